#include "loosefit/kinds/shirt/lay_shirt.h"

#include <algorithm>
#include <utility>

#include "loosefit/base/error.h"
#include "loosefit/dress/body_outline.h"
#include "loosefit/dress/sheets.h"
#include "loosefit/kinds/shirt/lay_bands.h"
#include "loosefit/kinds/shirt/shirt_frame.h"
#include "loosefit/kinds/shirt/shirt_values.h"

namespace loosefit::kinds {
namespace {

/// The part of a seam that ends lowest: the one below a dart.
std::string lowest_part(const garment::Garment& g, const std::string& part,
                        const std::string& seam) {
  return g.find_part(part, seam + "_below") ? seam + "_below" : seam;
}

/// Lays a seam along a line that begins where it meets `first`. Cut for a dart it has two parts,
/// and the lower one ends where it meets `last`; the legs of the dart are sewn to each other and
/// lie inside the piece.
void lay_seam(dress::PanelOutline& panel, const garment::Garment& g, const std::string& part,
              const std::string& seam, const std::string& first, const std::string& last,
              const std::vector<Vec2>& line) {
  const std::string below = seam + "_below";
  const auto *upper = g.find_part(part, seam), *lower = g.find_part(part, below);
  if (!upper || !lower) {
    panel.lay(seam, first, line);
    return;
  }
  // By the divisions of the mesh, which are the same on both pieces that meet here.
  const double up = static_cast<double>(upper->vertices.size() - 1),
               down = static_cast<double>(lower->vertices.size() - 1);
  auto [above, rest] = cut_line(line, down / (up + down));
  panel.lay(seam, first, above);
  std::reverse(rest.begin(), rest.end());
  panel.lay(below, last, rest);
}

void lay_torso(dress::PanelOutline& panel, const garment::Garment& g, const std::string& part,
               const ShirtFrame& frame, const std::vector<Vec2>& neck) {
  const auto &l = frame.left, &r = frame.right;
  // Waist darts of the back part the hem; their legs lie inside the piece as those of others.
  const auto *beyond = g.find_part(part, "hem_L"), *between = g.find_part(part, "hem");
  const std::string hem_l = beyond ? "hem_L" : "hem", hem_r = beyond ? "hem_R" : "hem";
  if (beyond && between) {
    const double aside = static_cast<double>(beyond->vertices.size() - 1),
                 middle = static_cast<double>(between->vertices.size() - 1);
    const Vec2 in = aside / (2 * aside + middle) * (r.hem - l.hem);
    const Vec2 dart_l = l.hem + in, dart_r = r.hem - in;
    panel.lay(hem_l, lowest_part(g, part, "side_L"), {l.hem, dart_l});
    panel.lay(hem_r, lowest_part(g, part, "side_R"), {r.hem, dart_r});
    panel.lay("hem", hem_l, {dart_l, dart_r});
  } else {
    panel.lay("hem", lowest_part(g, part, "side_L"), {l.hem, r.hem});
  }
  lay_seam(panel, g, part, "side_L", "armhole_L", hem_l, {l.armpit, l.hem});
  lay_seam(panel, g, part, "side_R", "armhole_R", hem_r, {r.armpit, r.hem});
  panel.lay("armhole_L", "side_L", l.armhole);
  panel.lay("armhole_R", "side_R", r.armhole);
  panel.lay("shoulder_L", "armhole_L", {l.shoulder, neck.front()});
  panel.lay("shoulder_R", "armhole_R", {r.shoulder, neck.back()});
  panel.lay("neck", "shoulder_L", neck);
}

void lay_neckband(dress::PanelOutline& panel, const std::vector<Vec2>& rim,
                  const std::vector<Vec2>& seam) {
  panel.lay("seam", "end_L", seam);
  panel.lay("rim", "end_L", rim);
  panel.lay("end_L", "seam", {seam.front(), rim.front()});
  panel.lay("end_R", "seam", {seam.back(), rim.back()});
}

/// Share of a sleeve's length, with its cuff, that is cuff.
double cuff_share(const garment::Garment& g, int side) {
  const double cuff = band_width(g, side > 0 ? "cuff_L_front" : "cuff_R_front");
  return cuff > 0 ? cuff / sleeve_length(g, side) : 0;
}

/// Half a sleeve or half its cuff, which goes on along the arm where the sleeve ends.
void lay_sleeve(dress::PanelOutline& panel, const garment::Garment& g, const ShirtPart& part,
                const ShirtFrame::Half& half) {
  const double cuff = cuff_share(g, part.side);
  const auto [top, cuff_top] = cut_line(half.sleeve_top, cuff);
  const auto [under, cuff_under] = cut_line(half.sleeve_under, cuff);
  if (part.band) {
    panel.lay("seam", "top", {top.back(), under.back()});
    panel.lay("rim", "top", {cuff_top.back(), cuff_under.back()});
    panel.lay("top", "seam", cuff_top);
    panel.lay("under", "seam", cuff_under);
    return;
  }
  panel.lay("cap", "under", half.armhole);
  panel.lay("top", "cap", top);
  lay_seam(panel, g, part.name, "under", "cap", "cuff", under);
  panel.lay("cuff", "top", {top.back(), under.back()});
}

}  // namespace

std::vector<Vec3> lay_shirt(const garment::Garment& g, const body::Body& body,
                            const dress::LayingRoom& room) {
  const dress::BodyOutline depth(body, room.clearance);
  const ShirtFrame frame = shirt_frame(g, body, depth, room.clearance);
  const NeckbandLines neck =
      neckband_lines(frame, band_width(g, "neckband_front"), room.straight_neck);
  dress::Sheets sheets(g);
  for (int p = 0; p < static_cast<int>(g.panel_names.size()); ++p) {
    const ShirtPart* part = find_shirt_part(g.panel_parts[p]);
    if (!part) throw GeometryError("pattern: panel " + g.panel_names[p] + " is no part of a shirt");
    dress::PanelOutline panel(g, part->name);
    if (part->sleeve)
      lay_sleeve(panel, g, *part, part->side > 0 ? frame.left : frame.right);
    else if (part->band)
      lay_neckband(panel, part->back ? neck.back_rim : neck.front_rim,
                   part->back ? neck.back_seam : neck.front_seam);
    else
      lay_torso(panel, g, part->name, frame, part->back ? neck.back_seam : neck.front_seam);
    sheets.add(p, panel, part->back);
  }
  return sheets.positions(depth, room);
}

}  // namespace loosefit::kinds

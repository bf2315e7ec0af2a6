#include "loosefit/kinds/shirt/lay_shirt.h"

#include <algorithm>
#include <utility>

#include "loosefit/base/error.h"
#include "loosefit/dress/body_outline.h"
#include "loosefit/dress/sheets.h"
#include "loosefit/kinds/shirt/shirt_frame.h"
#include "loosefit/kinds/shirt/shirt_values.h"

namespace loosefit::kinds {
namespace {

/// The first part of a polyline, as long as this share of it, and the rest.
std::pair<std::vector<Vec2>, std::vector<Vec2>> cut_line(const std::vector<Vec2>& line,
                                                         double share) {
  double rest = 0;
  for (std::size_t i = 1; i < line.size(); ++i) rest += share * (line[i] - line[i - 1]).norm();
  std::vector<Vec2> before = {line.front()};
  for (std::size_t i = 1; i < line.size(); ++i) {
    const double step = (line[i] - line[i - 1]).norm();
    if (rest < step) {
      const Vec2 cut = line[i - 1] + rest / step * (line[i] - line[i - 1]);
      before.push_back(cut);
      std::vector<Vec2> after = {cut};
      after.insert(after.end(), line.begin() + static_cast<std::ptrdiff_t>(i), line.end());
      return {before, after};
    }
    rest -= step;
    before.push_back(line[i]);
  }
  return {line, {line.back(), line.back()}};
}

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
  auto [above, rest] = cut_line(line, up / (up + down));
  panel.lay(seam, first, above);
  std::reverse(rest.begin(), rest.end());
  panel.lay(below, last, rest);
}

}  // namespace

std::vector<Vec3> lay_shirt(const garment::Garment& g, const body::Body& body,
                            const dress::LayingRoom& room) {
  const dress::BodyOutline depth(body, room.clearance);
  const ShirtFrame frame = shirt_frame(g, body, depth, room.clearance);
  dress::Sheets sheets(g);
  for (int p = 0; p < static_cast<int>(g.panel_names.size()); ++p) {
    const ShirtPart* part = find_shirt_part(g.panel_parts[p]);
    if (!part) throw GeometryError("pattern: panel " + g.panel_names[p] + " is no part of a shirt");
    dress::PanelOutline panel(g, part->name);
    if (!part->sleeve) {
      const auto &l = frame.left, &r = frame.right;
      panel.lay("hem", lowest_part(g, part->name, "side_L"), {l.hem, r.hem});
      lay_seam(panel, g, part->name, "side_L", "armhole_L", "hem", {l.armpit, l.hem});
      lay_seam(panel, g, part->name, "side_R", "armhole_R", "hem", {r.armpit, r.hem});
      panel.lay("armhole_L", "side_L", l.armhole);
      panel.lay("armhole_R", "side_R", r.armhole);
      panel.lay("shoulder_L", "armhole_L", {l.shoulder, l.neck});
      panel.lay("shoulder_R", "armhole_R", {r.shoulder, r.neck});
      panel.lay(
          "neck", "shoulder_L",
          part->back || room.straight_neck ? std::vector<Vec2>{l.neck, r.neck} : frame.front_neck);
    } else {
      const auto& half = part->side > 0 ? frame.left : frame.right;
      panel.lay("cap", "under", half.armhole);
      panel.lay("top", "cap", half.sleeve_top);
      lay_seam(panel, g, part->name, "under", "cap", "cuff", half.sleeve_under);
      panel.lay("cuff", "top", {half.sleeve_top.back(), half.sleeve_under.back()});
    }
    sheets.add(p, panel, part->back);
  }
  return sheets.positions(depth, room);
}

}  // namespace loosefit::kinds

#include "loosefit/kinds/shirt/shirt_levels.h"

#include <algorithm>
#include <cmath>

#include "loosefit/kinds/shirt/back_waist.h"
#include "loosefit/kinds/shirt/shirt_blocks.h"
#include "loosefit/kinds/shirt/shirt_values.h"
#include "loosefit/kinds/shirt/side_seams.h"
#include "loosefit/kinds/shirt/sleeve_ease.h"
#include "loosefit/kinds/shirt/sleeve_width.h"
#include "loosefit/pattern/outline.h"

namespace loosefit::kinds {
namespace {

constexpr double kArm = 0.585;  ///< where its length is not known [m]

std::optional<double> value_of(const NamedValues& values, const char* name) {
  const auto found = values.find(name);
  return found == values.end() ? std::nullopt : std::optional(found->second);
}

/// Girth of the arm where a sleeve of this share of its length ends.
std::optional<double> arm_at(const BodyMeasures& measures, double share) {
  if (!measures.count("upper_arm") || !measures.count("wrist")) return std::nullopt;
  return arm_girth_at(shirt_measures_of(measures), share);
}

/// y where the side seams of a body piece begin, at the underarm.
double underarm_level(const pattern::Panel& piece) {
  const int e = pattern::find_edge_part(piece, "armhole_L");
  if (e < 0) return 0;
  const pattern::PanelEdge& armhole = piece.edges[e];
  return std::min(piece.vertices[armhole.start].y(), piece.vertices[armhole.end].y());
}

/// Where the cap of a sleeve is.
struct CapPlace {
  double top = 0, foot = 0;  ///< y of its ends
  double dropped = 0;        ///< of its top beyond the body's shoulder point [m]
  /// How far below the shoulder point it ends [m].
  double underarm() const { return top - foot + dropped; }
};
/// Nothing without sleeves. The cap begins where the shoulder of the piece ends, beyond the body's
/// shoulder point.
std::optional<CapPlace> cap_place(const pattern::Pattern& shirt, const ShirtMeasures& m) {
  const int front = shirt.find_part("front"), sleeve = shirt.find_part("sleeve_L_front");
  if (front < 0 || sleeve < 0) return {};
  const auto ends = [&](int panel, const char* edge) -> std::optional<std::pair<Vec2, Vec2>> {
    const pattern::Panel& piece = shirt.panels[panel];
    const int e = pattern::find_edge_part(piece, edge);
    if (e < 0) return {};
    return std::pair{piece.vertices[piece.edges[e].start], piece.vertices[piece.edges[e].end]};
  };
  const auto cap = ends(sleeve, "cap"), seam = ends(front, "shoulder_L");
  if (!cap || !seam) return {};
  const double shoulder_end = std::max(std::abs(seam->first.x()), std::abs(seam->second.x()));
  return CapPlace{std::max(cap->first.y(), cap->second.y()),
                  std::min(cap->first.y(), cap->second.y()),
                  shoulder_end - shoulder_half_width(m)};
}

/// Girth of the arm that the width of a sleeve counts against; nothing where it is not known.
std::optional<double> arm_of_sleeve(const pattern::Pattern& shirt, const BodyMeasures& measures,
                                    const NamedValues& fit) {
  if (!measures.count("upper_arm")) return {};
  const ShirtMeasures m = shirt_measures_of(measures);
  const std::optional<CapPlace> cap = cap_place(shirt, m);
  return cap ? arm_under_sleeve(m, shirt_fit_of(fit), cap->underarm()) : m.upper_arm;
}

double lowest(const pattern::Panel& piece) {
  double low = piece.vertices.front().y();
  for (const Vec2& p : piece.vertices) low = std::min(low, p.y());
  return low;
}

}  // namespace

NamedValues shirt_girths(const pattern::Pattern& shirt, double hps_to_waist) {
  NamedValues girths;
  // A part that a pattern does not name has width 0, and its girth is left out.
  const auto width = [&](const char* panel, const char* edge_a, const char* edge_b, auto&& point) {
    const int p = shirt.find_part(panel);
    if (p < 0) return 0.0;
    const pattern::Panel& piece = shirt.panels[p];
    const int a = pattern::find_edge_part(piece, edge_a),
              b = pattern::find_edge_part(piece, edge_b);
    return a < 0 || b < 0 ? 0.0 : (point(piece, a) - point(piece, b)).norm();
  };
  const auto add = [&](const std::string& name, double front, double back) {
    if (front > 0 && back > 0) girths[name] = front + back;
  };
  // Chest: from underarm to underarm.
  const auto end_of_left = [](const pattern::Panel& piece, int e) -> Vec2 {
    // The underarm corner is where the armhole edge meets the side edge.
    const pattern::PanelEdge& edge = piece.edges[e];
    const Vec2 &start = piece.vertices[edge.start], &end = piece.vertices[edge.end];
    return start.y() < end.y() ? start : end;
  };
  add("chest", width("front", "armhole_L", "armhole_R", end_of_left),
      width("back", "armhole_L", "armhole_R", end_of_left));
  // Waist: where the side seams of the back cross its level, and what is sewn to them there.
  const int front = shirt.find_part("front"), back = shirt.find_part("back");
  if (front >= 0 && back >= 0) {
    const SideSeams before(shirt.panels[front]), behind(shirt.panels[back]);
    const double down = behind.down_to(-hps_to_waist);
    add("waist", before.apart(down),
        behind.apart(down) - back_darts_take(shirt.panels[back], -hps_to_waist));
  }
  // Hip: straight between the ends of the hem, which may be curved.
  const auto hem_width = [&](const char* panel) {
    const int p = shirt.find_part(panel);
    const auto hem = p < 0 ? std::nullopt : body_hem(shirt.panels[p]);
    return hem ? hem->girth : 0.0;
  };
  add("hip", hem_width("front"), hem_width("back"));
  const auto length = [&](const char* panel, const char* edge) {
    const int p = shirt.find_part(panel);
    const int e = p < 0 ? -1 : pattern::find_edge_part(shirt.panels[p], edge);
    return e < 0 ? 0.0 : pattern::EdgePath(shirt.panels[p], e).length();
  };
  // Sleeve: straight between the ends of its cap; wrist: along the cuff.
  const auto cap_width = [&](const char* panel) {
    const int p = shirt.find_part(panel);
    const int e = p < 0 ? -1 : pattern::find_edge_part(shirt.panels[p], "cap");
    if (e < 0) return 0.0;
    const pattern::PanelEdge& cap = shirt.panels[p].edges[e];
    return std::abs(shirt.panels[p].vertices[cap.end].x() -
                    shirt.panels[p].vertices[cap.start].x());
  };
  add("sleeve", cap_width("sleeve_L_front"), cap_width("sleeve_L_back"));
  // Its free end: the rim of a cuff, or that of the sleeve, which is called so, too.
  if (shirt.find_part("cuff_L_front") >= 0)
    add("wrist", length("cuff_L_front", "rim"), length("cuff_L_back", "rim"));
  else
    add("wrist", length("sleeve_L_front", "cuff"), length("sleeve_L_back", "cuff"));
  return girths;
}

std::vector<FitLevel> shirt_levels(const pattern::Pattern& shirt, const BodyMeasures& measures,
                                   const NamedValues& fit) {
  const std::optional<double> waist_level = value_of(measures, "hps_to_waist");
  const NamedValues girths = shirt_girths(shirt, waist_level.value_or(0));
  std::vector<FitLevel> levels;
  const auto add = [&](const char* name, const char* girth, const std::optional<double>& body) {
    if (const auto found = girths.find(girth); found != girths.end())
      levels.push_back({name, found->second, body});
  };
  add("chest", "chest", value_of(measures, "chest"));
  if (waist_level) add("waist", "waist", value_of(measures, "waist"));
  add("hip", "hip", value_of(measures, "hip"));
  add("sleeve", "sleeve", arm_of_sleeve(shirt, measures, fit));
  const double length = value_of(fit, "sleeve_length").value_or(1);
  // A cuff counts against the arm at its seam.
  const int cuff = shirt.find_part("cuff_L_front");
  const double width =
      cuff < 0 ? 0 : -lowest(shirt.panels[cuff]) / value_of(measures, "arm_length").value_or(kArm);
  if (length < 1)
    add("cuff", "wrist", arm_at(measures, length - width));
  else if (cuff >= 0)
    add("wrist", "wrist", arm_at(measures, 1 - width));
  else
    add("wrist", "wrist", value_of(measures, "wrist"));
  return levels;
}

std::vector<FitStation> shirt_stations(const pattern::Pattern& shirt,
                                       const BodyMeasures& measures, const NamedValues& fit) {
  const auto piece = [&](const char* part) {
    const int p = shirt.find_part(part);
    return p < 0 ? nullptr : &shirt.panels[p];
  };
  const ShirtMeasures m = shirt_measures_of(measures);
  const ShirtFit f = shirt_fit_of(fit);
  const bool asked = !fit.empty();
  std::vector<FitStation> stations;
  const pattern::Panel *front = piece("front"), *back = piece("back");
  if (!front || !back) return stations;

  // Trunk: y = 0 at the high point shoulder; the back tells how far down its hem is.
  const double underarm = -underarm_level(*back);
  std::vector<AskedMobility> trunk;
  if (asked) {
    trunk.push_back({underarm, f.chest});
    if (f.waist) trunk.push_back({m.hps_to_waist, *f.waist});
    trunk.push_back({m.hps_to_hem, f.hip});
  }
  const SideSeams before(*front), behind(*back);
  // It has a girth down to the highest place of its hem.
  const std::optional<BodyHem> hem = body_hem(*back);
  const double end = std::min(m.hps_to_hem, hem ? -hem->highest : m.hps_to_hem);
  stations = stations_along(
      "trunk", {back}, underarm, end, [](double along) { return -along; }, trunk);
  for (FitStation& s : stations) {
    const double down = behind.down_to(-s.along);
    s.garment += before.apart(down);
    s.lines.push_back({front->part, before.level(down)});
  }

  const pattern::Panel *sleeve_front = piece("sleeve_L_front"),
                       *sleeve_back = piece("sleeve_L_back");
  const std::optional<CapPlace> cap = cap_place(shirt, m);
  if (!cap || !sleeve_back) return stations;
  const double top = cap->top, dropped = cap->dropped;
  std::vector<AskedMobility> arm;
  if (asked)
    arm = sleeve_eases(m, f, cap->underarm());
  std::vector<FitStation> sleeve = stations_along(
      "arm", {sleeve_front}, cap->underarm(), m.arm_length,
      [&](double along) { return top + dropped - along; }, arm);
  for (FitStation& s : sleeve) {
    s.garment += width_below_cap(*sleeve_back, s.along - dropped);
    s.lines.push_back({sleeve_back->part, top + dropped - s.along});
  }
  stations.insert(stations.end(), sleeve.begin(), sleeve.end());

  // A cuff goes on where the sleeve ends; y = 0 is its seam.
  const pattern::Panel *cuff_front = piece("cuff_L_front"), *cuff_back = piece("cuff_L_back");
  if (!cuff_front || !cuff_back) return stations;
  const double cuff_seam = top + dropped - lowest(*sleeve_front);
  if (asked) arm = {{cuff_seam, f.wrist}};
  const std::vector<FitStation> cuff = stations_along(
      "arm", {cuff_front, cuff_back}, cuff_seam, cuff_seam - lowest(*cuff_front),
      [&](double along) { return cuff_seam - along; }, arm);
  stations.insert(stations.end(), cuff.begin(), cuff.end());
  return stations;
}

}  // namespace loosefit::kinds

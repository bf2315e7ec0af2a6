#include "loosefit/pipeline/file_girths.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>

#include "loosefit/base/error.h"
#include "loosefit/drape/openings.h"
#include "loosefit/drape/panel_roles.h"
#include "loosefit/garment/assemble.h"
#include "loosefit/garment/open_seams.h"
#include "loosefit/kinds/trousers/trousers_measures.h"
#include "loosefit/pattern/outline.h"
#include "loosefit/pattern/piece_names.h"

namespace loosefit::pipeline {
namespace {

using drape::PanelRole;
using kinds::OpeningUse;

constexpr double kMesh = 0.02;          ///< edges of the mesh that tells openings [m]
constexpr double kBelowArmhole = 0.01;  ///< where a trunk is whole [m]
constexpr double kOnUpperArm = 0.02;    ///< below the armhole [m]
constexpr double kCrotchRoom = 0.015;   ///< of trousers below the crotch, as they are put on [m]
constexpr double kBelowHip = 0.02;      ///< down to which a trunk is one [m]
constexpr double kOffMiddle = 0.03;     ///< of a panel that lies to one side [m]
constexpr double kLongSleeve = 0.85;    ///< of the arm
constexpr double kSlit = 0.2;           ///< widest slit in a hem, of the width of its piece

/// Where the level line n · x = at in the plane of a panel enters and leaves its outline, in turn
/// [m].
std::vector<double> crossings_on(const pattern::Panel& panel, const Vec3& n, double at) {
  const Vec2 slope(panel.rotation.col(0).dot(n), panel.rotation.col(1).dot(n));
  if (slope.norm() < 0.3) return {};  // lies across
  const Vec2 up = slope.normalized(), along(up.y(), -up.x());
  const double level = (at - panel.translation.dot(n)) / slope.norm();
  const std::vector<Vec2> outline = pattern::outline_polygon(panel);
  std::vector<double> crossings;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2 &a = outline[i], &b = outline[(i + 1) % outline.size()];
    const double s = a.dot(up), t = b.dot(up);
    if ((s < level) != (t < level))
      crossings.push_back(Vec2(a + (level - s) / (t - s) * (b - a)).dot(along));
  }
  std::sort(crossings.begin(), crossings.end());
  return crossings;
}

/// Length of such a line within the outline [m].
double width_on(const pattern::Panel& panel, const Vec3& n, double at) {
  const std::vector<double> crossings = crossings_on(panel, n, at);
  double width = 0;
  for (std::size_t i = 0; i + 1 < crossings.size(); i += 2)
    width += crossings[i + 1] - crossings[i];
  return width;
}

/// Whether a piece ends above a level in its middle: what is left are the corners of its hem.
bool has_ended_in_its_middle(const pattern::Panel& panel, double z) {
  const std::vector<double> crossings = crossings_on(panel, Vec3::UnitZ(), z);
  if (crossings.size() < 4) return false;
  const double span = crossings.back() - crossings.front();
  const double middle = 0.5 * (crossings.front() + crossings.back());
  for (std::size_t i = 1; i + 2 < crossings.size(); i += 2)
    if (crossings[i] < middle && middle < crossings[i + 1])
      return crossings[i + 1] - crossings[i] > kSlit * span;
  return false;
}

class Measurer {
 public:
  Measurer(const pattern::Pattern& pattern, const kinds::NamedValues& measured)
      : measured_(measured),
        sewn_(garment::assemble(pattern, kMesh, fabric::Material{})),
        open_(garment::open_seams(sewn_)),
        openings_(drape::garment_openings(sewn_, pattern)) {
    const garment::Garment& g = open_.garment;
    for (const std::string& name : g.panel_names)
      panels_.push_back(&pattern.panels[pattern.find_panel(name)]);
    for (int v = 0; v < g.vertex_count; ++v) {
      const pattern::Panel& panel = *panels_[g.vertex_panel[v]];
      placed_.push_back(panel.rotation * Vec3(g.vertex_uv[v][0], g.vertex_uv[v][1], 0) +
                        panel.translation);
    }
    roles_ = drape::panel_roles(open_, pattern, openings_, placed_);
    for (std::size_t k = 0; k < panels_.size(); ++k) {
      const pattern::PieceWords w = pattern::words_of(*panels_[k]);
      const bool band =
          w.waist || w.hem || w.cuff || w.hood || w.pocket || (w.neck && !w.front && !w.back);
      whole_.push_back(!band);
    }
    find_sides();
  }

  FileGirths measure() {
    if (!armholes().empty())
      hangs_on_shoulders();
    else if (const auto crotch = placed_crotch())
      has_legs(*crotch);
    else
      is_tube();
    sleeve();
    return std::move(result_);
  }

 private:
  std::optional<double> body(const std::string& name) const {
    const auto found = measured_.find(name);
    return found == measured_.end() ? std::nullopt : std::optional(found->second);
  }

  void add(const std::string& name, double girth, const std::optional<double>& of_body) {
    if (girth > 0) result_.levels.push_back({name, girth, of_body});
  }

  int panel_of(int v) const { return open_.garment.vertex_panel[v]; }

  /// Of every panel +1 on the left, −1 on the right, 0 across the middle.
  void find_sides() {
    std::vector<double> low(panels_.size(), std::numeric_limits<double>::infinity()), high;
    for (double& x : low) high.push_back(-x);
    for (std::size_t v = 0; v < placed_.size(); ++v) {
      const int k = panel_of(static_cast<int>(v));
      low[k] = std::min(low[k], placed_[v].x()), high[k] = std::max(high[k], placed_[v].x());
    }
    const double middle = 0.5 * (*std::ranges::min_element(low) + *std::ranges::max_element(high));
    for (std::size_t k = 0; k < panels_.size(); ++k) {
      const double off = 0.5 * (low[k] + high[k]) - middle;
      side_.push_back(off > kOffMiddle ? 1 : off < -kOffMiddle ? -1 : 0);
    }
  }

  bool is_of_arm(OpeningUse use) const {
    return use == OpeningUse::left_arm || use == OpeningUse::right_arm;
  }

  /// Vertices of the trunk at seams to sleeves and at openings for arms.
  std::vector<int> armholes() const {
    std::vector<int> found;
    for (const std::vector<int>& of : open_.partners) {
      const bool arm = std::ranges::any_of(of, [&](int v) { return role(v) != PanelRole::trunk; });
      for (int v : of)
        if (arm && role(v) == PanelRole::trunk) found.push_back(v);
    }
    for (const drape::Opening& o : openings_) {
      if (!is_of_arm(o.use)) continue;
      const std::set<int> loop(o.loop.begin(), o.loop.end());
      for (int v = 0; v < open_.garment.vertex_count; ++v)
        if (role(v) == PanelRole::trunk && loop.count(open_.sewn[v])) found.push_back(v);
    }
    return found;
  }

  PanelRole role(int v) const { return roles_[panel_of(v)]; }

  /// Girth of the trunk at a height, 0 where front or back has ended.
  double trunk(double z, int side = 0) const {
    double before = 0, behind = 0, beside = 0;
    for (std::size_t k = 0; k < panels_.size(); ++k) {
      if (roles_[k] != PanelRole::trunk || !whole_[k] || (side != 0 && side_[k] != side)) continue;
      if (has_ended_in_its_middle(*panels_[k], z)) return 0;
      const double width = width_on(*panels_[k], Vec3::UnitZ(), z);
      const double y = panels_[k]->rotation.col(2).y();
      (y < -0.7 ? before : y > 0.7 ? behind : beside) += width;
    }
    const bool all_round = (before > 0 && behind > 0) || (before == 0 && behind == 0);
    return all_round ? before + behind + beside : 0;
  }

  double lowest_of_trunk() const {
    double lowest = std::numeric_limits<double>::infinity();
    for (std::size_t v = 0; v < placed_.size(); ++v)
      if (role(static_cast<int>(v)) == PanelRole::trunk && whole_[panel_of(static_cast<int>(v))])
        lowest = std::min(lowest, placed_[v].z());
    return lowest;
  }

  void add_stations(double z_of_hps, double from, double to) {
    for (int i = static_cast<int>(std::ceil(from / kinds::kStationStep));
         i * kinds::kStationStep <= to; ++i) {
      const double along = i * kinds::kStationStep;
      if (const double girth = trunk(z_of_hps - along); girth > 0)
        result_.stations.push_back({"trunk", along, girth, {}});
    }
  }

  void hangs_on_shoulders() {
    double top = -std::numeric_limits<double>::infinity();
    double underarm = std::numeric_limits<double>::infinity();
    std::set<int> with_armhole;
    for (int v : armholes())
      with_armhole.insert(panel_of(v)), underarm = std::min(underarm, placed_[v].z());
    for (std::size_t v = 0; v < placed_.size(); ++v)
      if (with_armhole.count(panel_of(static_cast<int>(v)))) top = std::max(top, placed_[v].z());
    const double whole = top - underarm + kBelowArmhole;
    const auto bust = body("hps_to_bust"), waist = body("hps_to_waist"), hip = body("hps_to_hip");
    const double at_bust = trunk(top - std::max(whole, bust.value_or(0)));
    // One that ends above the bust is measured where it is whole.
    add("chest", at_bust > 0 ? at_bust : trunk(top - whole), body("chest"));
    const double length = top - lowest_of_trunk();
    if (waist && *waist > whole) add("waist", trunk(top - *waist), body("waist"));
    if (hip && *hip > whole) add("hip", trunk(top - *hip), body("hip"));
    add_hem();
    add_stations(top, whole, std::min(length, hip.value_or(0) + kBelowHip));
  }

  void has_legs(double crotch) {
    if (const drape::Opening* top = highest()) add("waist", top->girth, body("waist"));
    const auto height = body("crotch_height"), hip_level = body("hip_level");
    const auto hps_to_hip = body("hps_to_hip");
    if (height && hip_level) {
      const double of_body = crotch + kCrotchRoom;  // where the body's crotch comes to lie
      const double hip = of_body + *hip_level - *height;
      add("hip", trunk(hip), body("hip"));
      if (hps_to_hip && highest())
        add_stations(hip + *hps_to_hip, *hps_to_hip - (highest()->placed.z() - hip),
                     *hps_to_hip + kBelowHip);
      for (const auto& [name, level] :
           {std::pair{"thigh", kinds::kThighLevel}, {"knee", kinds::kKneeLevel}})
        add(name, leg(of_body - (1 - level) * *height), body(name));
    } else {
      add("thigh", leg(crotch - kOnUpperArm), body("thigh"));
    }
    for (const drape::Opening& o : openings_)
      if (o.use == OpeningUse::left_leg) add("hem", o.girth, {});
  }

  double leg(double z) const { return trunk(z, 1); }

  void is_tube() {
    const drape::Opening* top = highest();
    if (!top || openings_.size() < 2) return;
    if (top->at_chest) {
      add("chest", top->girth, body("chest"));
    } else {
      add("waist", top->girth, body("waist"));
      const auto waist = body("hps_to_waist"), hip = body("hps_to_hip");
      if (waist && hip) {
        add("hip", trunk(top->placed.z() - (*hip - *waist)), body("hip"));
        const double hps = top->placed.z() + *waist;
        add_stations(hps, *waist, std::min(hps - lowest_of_trunk(), *hip + kBelowHip));
      }
    }
    add_hem();
  }

  void add_hem() {
    for (const drape::Opening& o : openings_)
      if (o.use == OpeningUse::hem) add("hem", o.girth, {});
  }

  const drape::Opening* highest() const {
    const drape::Opening* top = nullptr;
    for (const drape::Opening& o : openings_)
      if (!top || drape::is_upper_end(o, *top)) top = &o;
    return top;
  }

  /// The lowest place at which left and right of a garment with legs are sewn together [m].
  std::optional<double> placed_crotch() const {
    const bool legs = std::ranges::any_of(
        openings_, [](const drape::Opening& o) { return o.use == OpeningUse::left_leg; });
    if (!legs) return {};
    double lowest = std::numeric_limits<double>::infinity();
    for (const std::vector<int>& of : open_.partners) {
      bool left = false, right = false;
      double z = 0;
      for (int v : of) {
        left = left || side_[panel_of(v)] > 0, right = right || side_[panel_of(v)] < 0;
        z += placed_[v].z() / static_cast<double>(of.size());
      }
      if (left && right) lowest = std::min(lowest, z);
    }
    return std::isfinite(lowest) ? std::optional(lowest) : std::nullopt;
  }

  /// The left one; along the line from the middle of its armhole to that of its end.
  void sleeve() {
    const drape::Opening* end = nullptr;
    for (const drape::Opening& o : openings_)
      if (o.use == OpeningUse::left_arm) end = &o;
    std::vector<int> hole, cuff;
    for (const std::vector<int>& of : open_.partners)
      if (std::ranges::any_of(of, [&](int v) { return role(v) == PanelRole::trunk; }))
        for (int v : of)
          if (role(v) == PanelRole::left_arm) hole.push_back(v);
    if (!end || hole.empty()) return;
    const std::set<int> loop(end->loop.begin(), end->loop.end());
    for (int v = 0; v < open_.garment.vertex_count; ++v)
      if (role(v) == PanelRole::left_arm && loop.count(open_.sewn[v])) cuff.push_back(v);
    if (cuff.empty()) return;
    const Vec3 from = mean(hole), axis = (mean(cuff) - from).normalized();
    double shoulder = std::numeric_limits<double>::infinity(), underarm = -shoulder;
    for (int v : hole) {
      const double s = placed_[v].dot(axis);
      shoulder = std::min(shoulder, s), underarm = std::max(underarm, s);
    }
    const double last = mean(cuff).dot(axis), length = last - shoulder;
    add("upper arm", arm(axis, std::min(underarm + kOnUpperArm, last - 1e-3)), body("upper_arm"));
    const auto arm_length = body("arm_length");
    const bool is_long = arm_length && length > kLongSleeve * *arm_length;
    add(is_long ? "wrist" : "sleeve end", end->girth, is_long ? body("wrist") : std::nullopt);
    for (int i = static_cast<int>(std::ceil((underarm - shoulder) / kinds::kStationStep));
         i * kinds::kStationStep < length; ++i)
      if (const double girth = arm(axis, shoulder + i * kinds::kStationStep); girth > 0)
        result_.stations.push_back({"arm", i * kinds::kStationStep, girth, {}});
  }

  Vec3 mean(const std::vector<int>& of) const {
    Vec3 sum = Vec3::Zero();
    for (int v : of) sum += placed_[v] / static_cast<double>(of.size());
    return sum;
  }

  /// Square to the axis in the plane of every panel of the left arm.
  double arm(const Vec3& axis, double at) const {
    double girth = 0;
    for (std::size_t k = 0; k < panels_.size(); ++k)
      if (roles_[k] == PanelRole::left_arm && whole_[k]) girth += width_on(*panels_[k], axis, at);
    return girth;
  }

  const kinds::NamedValues& measured_;
  garment::Garment sewn_;
  garment::OpenSeams open_;
  std::vector<drape::Opening> openings_;
  std::vector<const pattern::Panel*> panels_;  ///< of the garment's
  std::vector<Vec3> placed_;                   ///< vertices of the open garment [m]
  std::vector<PanelRole> roles_;
  std::vector<char> whole_;  ///< per panel: goes into girths
  std::vector<int> side_;
  FileGirths result_;
};

}  // namespace

FileGirths file_girths(const pattern::Pattern& pattern, const kinds::NamedValues& measured) {
  if (pattern.stitches.empty()) return {};
  try {
    return Measurer(pattern, measured).measure();
  } catch (const InvalidInput&) {  // cannot be meshed or sewn, which whoever wears it is told
    return {};
  }
}

}  // namespace loosefit::pipeline

#include "loosefit/drape/arrange_panels.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>

#include "loosefit/base/error.h"
#include "loosefit/drape/clear_panel.h"
#include "loosefit/drape/lay_bands.h"
#include "loosefit/drape/limb_lines.h"
#include "loosefit/drape/limb_pieces.h"
#include "loosefit/drape/openings.h"
#include "loosefit/drape/panel_roles.h"
#include "loosefit/drape/polyline.h"
#include "loosefit/drape/rest_levels.h"
#include "loosefit/drape/rolled_panel.h"
#include "loosefit/drape/skirt_width.h"
#include "loosefit/drape/sleeve_middle.h"
#include "loosefit/drape/wrapped_leg.h"
#include "loosefit/geometry/box.h"
#include "loosefit/geometry/rotation_between.h"

namespace loosefit::drape {
namespace {

constexpr double kAgrees = 0.03;     ///< a placement so near is kept [m]
constexpr double kStraight = 0.002;  ///< a top whose heights differ by less is straight [m]
constexpr double kClear = 0.02;      ///< of a panel from the body [m]
constexpr double kBeyond = 0.03;     ///< of a sleeve from its armhole, along the arm [m]
constexpr double kFromAxis =
    0.04;                       ///< of a panel of a sleeve from the line of the arm, at least [m]
constexpr double kStep = 0.01;  ///< by which such a panel is moved outwards [m]
constexpr int kSteps = 30;      ///< at most
constexpr double kSideways = 0.5;      ///< |n_y| below which a panel lies beside the body
constexpr double kBesideLeg = 0.7;     ///< n_x from which a panel stands beside a leg
constexpr double kOffMiddle = 0.03;    ///< centre of a panel that lies to one side [m]
constexpr double kAboveAnkle = 0.04;   ///< of a trouser leg that is sewn, above the ankle [m]
constexpr double kForTheChest = 0.9;   ///< of the chest's girth, from which a tube may go round it
constexpr double kShortest = 0.05;     ///< of a leg that is one [m]
constexpr double kCrotchRoom = 0.015;  ///< of trousers below the crotch [m]

class Arranger {
 public:
  Arranger(const garment::Garment& sewn, const garment::OpenSeams& open,
           const pattern::Pattern& pattern, const body::PosedBody& body)
      : sewn_(sewn), open_(open), g_(open.garment), pattern_(pattern), body_(body) {
    x_.reserve(g_.vertex_count);
    for (const std::string& name : g_.panel_names) {
      const int k = pattern.find_panel(name);
      if (k < 0) throw GeometryError("pattern: panel " + name + " is missing");
      outside_.push_back(pattern.panels[k].rotation.col(2));
    }
    for (int v = 0; v < g_.vertex_count; ++v) {
      const pattern::Panel& panel =
          pattern.panels[pattern.find_panel(g_.panel_names[g_.vertex_panel[v]])];
      x_.push_back(panel.rotation * Vec3(g_.vertex_uv[v][0], g_.vertex_uv[v][1], 0) +
                   panel.translation);
    }
    placed_ = x_;
  }

  ArrangedPanels arrange() {
    bool under_soles = false;
    if (!limb_lines(body_.body())[kHead].empty()) {
      openings_ = garment_openings(sewn_, pattern_, body_);
      under_soles = goes_under_soles(sewn_, pattern_, openings_);
      roles_ = panel_roles(open_, pattern_, openings_, placed_);
      const LimbPieces on_limbs(sewn_, open_, openings_, body_);
      for (std::size_t k = 0; k < roles_.size(); ++k)
        if (on_limbs.has(static_cast<int>(k))) roles_[k] = PanelRole::limb;
      std::erase_if(openings_, [](const Opening& o) { return o.use == kinds::OpeningUse::limb; });
      find_sides();
      bands_ = find_bands(open_, roles_);
      const Vec3 shift = trunk_shift();
      for (int v = 0; v < g_.vertex_count; ++v)
        if (role(v) == PanelRole::trunk) x_[v] += shift;
      if (const auto crotch = placed_crotch()) {
        wrapped_ = find_wrapped_legs(open_, side_);
        std::erase_if(wrapped_, [&](int k) { return side_[k] * outside_[k].x() < kBesideLeg; });
        along_leg(*crotch + shift.z(), 1, "_L");
        along_leg(*crotch + shift.z(), -1, "_R");
        std::erase_if(wrapped_, [&](int k) { return !wrap_leg(open_, k, side_[k], body_, x_); });
        for (int k : wrapped_) outside_[k].setZero();
      }
      std::vector<int> trunk = trunk_vertices();
      std::erase_if(trunk, [&](int v) { return is_wrapped(g_.vertex_panel[v]); });
      squeeze_above_floor(x_, trunk, body_);
      // The arms are within a cape.
      if (loop_of(kinds::OpeningUse::cape_hem).empty()) {
        squeeze_between_hands(x_, trunk, body_);
        if (loop_of(kinds::OpeningUse::left_leg).empty() &&
            loop_of(kinds::OpeningUse::right_leg).empty())
          stretch_round_body(x_, trunk, body_);
      }
      along_arm(PanelRole::left_arm, "_L");
      along_arm(PanelRole::right_arm, "_R");
      for (std::size_t k = 0; k < outside_.size(); ++k)
        if (roles_[k] == PanelRole::trunk && !bands_.count(static_cast<int>(k)) &&
            !is_wrapped(static_cast<int>(k)) && !roll_round_trunk(static_cast<int>(k)))
          clear_trunk(static_cast<int>(k));
      lay_bands(open_, bands_, roles_, placed_crotch() ? side_ : std::vector<int>{}, body_, x_);
      for (const auto& [k, band] : bands_) outside_[k].setZero();
      on_limbs.lay(pattern_, x_, outside_);
    } else {
      for (std::size_t k = 0; k < outside_.size(); ++k) clear_along_normal(static_cast<int>(k));
    }
    std::vector<char> of_trunk(outside_.size(), 0);
    for (std::size_t k = 0; k < roles_.size(); ++k) of_trunk[k] = roles_[k] == PanelRole::trunk;
    const bool on_limbs = std::ranges::count(roles_, PanelRole::limb) > 0;
    return {.x = std::move(x_),
            .outside = std::move(outside_),
            .of_trunk = std::move(of_trunk),
            .shoulders = shoulder_seams(),
            .on_limbs = on_limbs,
            .under_soles = under_soles};
  }

 private:
  /// Without bands in one piece, which are longer in the plane than the body is wide.
  std::vector<int> trunk_vertices() const {
    std::vector<int> found;
    for (int v = 0; v < g_.vertex_count; ++v)
      if (role(v) == PanelRole::trunk && !bands_.count(g_.vertex_panel[v])) found.push_back(v);
    return found;
  }

  bool is_wrapped(int panel) const {
    return std::find(wrapped_.begin(), wrapped_.end(), panel) != wrapped_.end();
  }

  PanelRole role(int v) const { return roles_[g_.vertex_panel[v]]; }

  /// Vertices of one side of an armhole: the trunk's where `of_trunk`, otherwise the sleeve's.
  std::vector<int> armhole(PanelRole arm, bool of_trunk) const {
    std::vector<int> found;
    for (const std::vector<int>& of : open_.partners) {
      const auto has = [&](PanelRole r) {
        return std::any_of(of.begin(), of.end(), [&](int v) { return role(v) == r; });
      };
      if (!has(arm) || !has(PanelRole::trunk)) continue;
      for (int v : of)
        if (role(v) == (of_trunk ? PanelRole::trunk : arm)) found.push_back(v);
    }
    return found;
  }

  std::set<int> loop_of(kinds::OpeningUse use) const {
    std::set<int> found;
    for (const Opening& o : openings_)
      if (o.use == use) found.insert(o.loop.begin(), o.loop.end());
    return found;
  }

  /// Vertices of the open garment, of those of the sewn one.
  std::vector<int> on_rim(const std::set<int>& loop) const {
    std::vector<int> found;
    for (int v = 0; v < g_.vertex_count; ++v)
      if (loop.count(open_.sewn[v])) found.push_back(v);
    return found;
  }

  Vec3 mean(const std::vector<int>& of, const std::vector<Vec3>& x) const {
    Vec3 sum = Vec3::Zero();
    for (int v : of) sum += x[v] / static_cast<double>(of.size());
    return sum;
  }

  std::vector<int> vertices_of(int panel) const {
    std::vector<int> of;
    for (int v = 0; v < g_.vertex_count; ++v)
      if (g_.vertex_panel[v] == panel) of.push_back(v);
    return of;
  }

  std::set<int> panels_of(const std::vector<int>& vertices) const {
    std::set<int> found;
    for (int v : vertices) found.insert(g_.vertex_panel[v]);
    return found;
  }

  /// Vertices of the trunk at its armholes: seams to sleeves, and openings for arms.
  std::vector<int> armholes() const {
    std::vector<int> holes = armhole(PanelRole::left_arm, true);
    const std::vector<int> right = armhole(PanelRole::right_arm, true);
    holes.insert(holes.end(), right.begin(), right.end());
    for (kinds::OpeningUse use : {kinds::OpeningUse::left_arm, kinds::OpeningUse::right_arm}) {
      for (int v : on_rim(loop_of(use)))
        if (role(v) == PanelRole::trunk) holes.push_back(v);
    }
    return holes;
  }

  /// Vertices of seams between panels with armholes that lie above the middle of these; of a cape,
  /// which has none, those no lower than its neck.
  std::vector<int> shoulder_seams() const {
    if (roles_.empty()) return {};
    const std::vector<int> holes = armholes();
    if (holes.empty()) return seams_beside_neck();
    const double middle = mean(holes, placed_).z();
    const std::set<int> with_armhole = panels_of(holes);
    std::vector<int> found;
    for (const std::vector<int>& of : open_.partners)
      if (std::all_of(of.begin(), of.end(), [&](int v) {
            return with_armhole.count(g_.vertex_panel[v]) && placed_[v].z() > middle;
          }))
        found.insert(found.end(), of.begin(), of.end());
    return found;
  }

  std::vector<int> seams_beside_neck() const {
    double lowest = std::numeric_limits<double>::infinity();
    for (int v : cape_neck()) lowest = std::min(lowest, placed_[v].z() - kAgrees);
    std::vector<int> found;
    for (const std::vector<int>& of : open_.partners)
      if (std::ranges::all_of(
              of, [&](int v) { return role(v) == PanelRole::trunk && placed_[v].z() > lowest; }))
        found.insert(found.end(), of.begin(), of.end());
    return found;
  }

  /// Vertices at the neck of a cape or poncho.
  std::vector<int> cape_neck() const {
    if (loop_of(kinds::OpeningUse::cape_hem).empty()) return {};
    return on_rim(loop_of(kinds::OpeningUse::neck));
  }

  // --- where the trunk's panels go

  Vec3 trunk_shift() const {
    geometry::Box3 box;
    for (int v : trunk_vertices()) box.extend(placed_[v]);
    if (box.isEmpty()) return Vec3::Zero();
    const double dx = body_->joints.at("neck").x() - 0.5 * (box.min().x() + box.max().x());
    const double dz = rise();
    return {std::abs(dx) > kAgrees ? dx : 0, 0, std::abs(dz) > kAgrees ? dz : 0};
  }

  double rise() const {
    for (const auto& dz : {rise_to_shoulders(), rise_to_crotch(), rise_to_neck(), rise_of_tube()})
      if (dz) return *dz;
    return 0;
  }

  std::optional<double> rise_to_shoulders() const {
    const std::set<int> with_armhole = panels_of(armholes());
    if (with_armhole.empty()) return {};
    geometry::Box3 box;
    for (int v = 0; v < g_.vertex_count; ++v)
      if (with_armhole.count(g_.vertex_panel[v])) box.extend(placed_[v]);
    const auto beside = [&](int v) {
      return std::abs(placed_[v].x() - 0.5 * (box.min().x() + box.max().x()));
    };
    // Of a top that is straight from hand to hand its middle lies on the shoulders.
    int top = -1;
    for (int v = 0; v < g_.vertex_count; ++v)
      if (with_armhole.count(g_.vertex_panel[v]) && placed_[v].z() > box.max().z() - kStraight &&
          (top < 0 || beside(v) < beside(top)))
        top = v;
    // The shoulder line of the body there.
    const auto& marks = body_->landmarks;
    for (const char* name : {"hps_L", "hps_R", "acromion_L", "acromion_R"})
      if (!marks.count(name)) return {};
    const double hps = 0.5 * (marks.at("hps_L").z() + marks.at("hps_R").z());
    const double tip = 0.5 * (marks.at("acromion_L").z() + marks.at("acromion_R").z());
    const double neck = 0.5 * (marks.at("hps_L").x() - marks.at("hps_R").x());
    const double breadth = 0.5 * (marks.at("acromion_L").x() - marks.at("acromion_R").x());
    const double share =
        std::clamp((beside(top) - neck) / std::max(0.01, breadth - neck), 0.0, 1.2);
    return hps + share * (tip - hps) - box.max().z();
  }

  /// The highest point of a cape's neck comes to where the neck meets the shoulders.
  std::optional<double> rise_to_neck() const {
    const std::vector<int> neck = cape_neck();
    const auto left = body_->landmarks.find("hps_L"), right = body_->landmarks.find("hps_R");
    if (neck.empty() || left == body_->landmarks.end() || right == body_->landmarks.end())
      return {};
    const auto lower = [&](int v, int w) { return placed_[v].z() < placed_[w].z(); };
    return 0.5 * (left->second.z() + right->second.z()) -
           placed_[*std::ranges::max_element(neck, lower)].z();
  }

  std::optional<double> rise_to_crotch() const {
    const auto found = body_->landmarks.find("crotch");
    const std::optional<double> crotch = placed_crotch();
    if (!crotch || found == body_->landmarks.end()) return {};
    return found->second.z() - kCrotchRoom - *crotch;
  }

  /// The lowest place at which the left side of a garment with legs is sewn to the right one [m].
  std::optional<double> placed_crotch() const {
    if (loop_of(kinds::OpeningUse::left_leg).empty()) return {};
    double lowest = std::numeric_limits<double>::infinity();
    for (const std::vector<int>& of : open_.partners) {
      bool left = false, right = false;
      for (int v : of) {
        left = left || side_[g_.vertex_panel[v]] > 0;
        right = right || side_[g_.vertex_panel[v]] < 0;
      }
      if (left && right) lowest = std::min(lowest, mean(of, placed_).z());
    }
    if (!std::isfinite(lowest)) return {};
    return lowest;
  }

  /// Of every panel: +1 on the left of the garment, −1 on the right, 0 across the middle.
  void find_sides() {
    std::vector<double> centre(outside_.size(), 0), count(outside_.size(), 0);
    geometry::Box3 box;
    for (int v = 0; v < g_.vertex_count; ++v) {
      centre[g_.vertex_panel[v]] += placed_[v].x(), ++count[g_.vertex_panel[v]];
      box.extend(placed_[v]);
    }
    const double middle = 0.5 * (box.min().x() + box.max().x());
    for (std::size_t k = 0; k < outside_.size(); ++k) {
      const double off = centre[k] / count[k] - middle;
      side_.push_back(off > kOffMiddle ? 1 : off < -kOffMiddle ? -1 : 0);
    }
  }

  std::optional<double> rise_of_tube() const {
    const Opening* top = nullptr;
    for (const Opening& o : openings_)
      if (!top || o.placed.z() > top->placed.z()) top = &o;
    if (!top || openings_.size() < 2) return {};
    const RestLevels levels(body_);
    const double crotch_way = levels.waist - levels.crotch;
    const auto girth = [&](const char* name, double otherwise) {
      const auto at = body_->measured.find(name);
      return at == body_->measured.end() ? otherwise : at->second;
    };
    const bool above_waist = top->placed.z() > levels.waist + kAgrees;
    const bool wide = top->girth > kForTheChest * girth("chest", 0.55 * levels.height);
    if (top->at_chest || (!top->at_waist && above_waist && wide)) {
      if (top->placed.z() > levels.waist && top->placed.z() < levels.chest + 0.5 * crotch_way)
        return 0;
      return levels.chest + 0.2 * crotch_way - top->placed.z();
    }
    if (!above_waist && top->placed.z() > levels.hip) return 0;
    const double waist = girth("waist", 0), hip = girth("hip", 0);
    const double share =
        hip > waist ? std::clamp((top->girth - waist) / (hip - waist), 0.0, 1.0) : 0.0;
    // Wider than the hips: it will slide; it is put on at the waist all the same.
    const double level = levels.waist - (share < 1 ? share : 0) * (levels.waist - levels.hip);
    return level - top->placed.z();
  }

  // --- legs

  /// Below the crotch the panels of a leg are sheared until its end is round the leg of the body,
  /// and squeezed until it is above the foot: a hem that begins before the toes would be sewn round
  /// the length of the foot. It comes down over it by itself.
  void along_leg(double crotch, int side, const std::string& name) {
    const std::vector<int> hem =
        on_rim(loop_of(side > 0 ? kinds::OpeningUse::left_leg : kinds::OpeningUse::right_leg));
    if (hem.empty()) return;
    const Vec3 end = mean(hem, x_);
    double lowest = end.z();
    for (int v : hem) lowest = std::min(lowest, x_[v].z());
    if (!(lowest < crotch - kShortest)) return;
    const auto& joints = body_->joints;
    const Vec3 &hip = joints.at("hip" + name), &knee = joints.at("knee" + name),
               &ankle = joints.at("ankle" + name);
    const double least = ankle.z() + kAboveAnkle;
    const double share = lowest < least ? (crotch - least) / (crotch - lowest) : 1;
    // The leg of the body where the hem will be.
    const double z = crotch - share * (crotch - end.z());
    const auto at = [z](const Vec3& a, const Vec3& b) {
      return a.x() + (a.z() - z) / (a.z() - b.z()) * (b.x() - a.x());
    };
    const double aside = (z > knee.z() ? at(hip, knee) : at(knee, ankle)) - end.x();
    for (int v = 0; v < g_.vertex_count; ++v) {
      if (side_[g_.vertex_panel[v]] != side || role(v) != PanelRole::trunk) continue;
      const double down = crotch - x_[v].z();
      if (down <= 0) continue;
      x_[v].x() += aside * down / (crotch - end.z());
      x_[v].z() = crotch - share * down;
    }
  }

  // --- arms

  void along_arm(PanelRole arm, const std::string& side) {
    std::vector<int> of;
    for (int v = 0; v < g_.vertex_count; ++v)
      if (role(v) == arm) of.push_back(v);
    const std::vector<int> hole = armhole(arm, false), trunk = armhole(arm, true);
    if (of.empty() || hole.empty()) return;
    const std::set<int> cuff = loop_of(arm == PanelRole::left_arm ? kinds::OpeningUse::left_arm
                                                                  : kinds::OpeningUse::right_arm);
    std::vector<int> end;
    for (int v : of)
      if (cuff.count(open_.sewn[v])) end.push_back(v);
    if (end.empty()) return;
    // The line of the sleeve where it is placed: square to the edge at its end, from that edge's
    // middle back.
    const Vec3 axis = sleeve_axis(end, hole);
    const Vec3 from = mean(end, placed_);
    double begin = 0;  // of the sleeve along the axis, seen from its end
    for (int v : hole) begin += (placed_[v] - from).dot(axis) / static_cast<double>(hole.size());
    const auto& joints = body_->joints;
    std::vector<Vec3> line = {joints.at("shoulder" + side), joints.at("elbow" + side),
                              joints.at("wrist" + side)};
    const auto hand = joints.find("hand" + side);
    if (hand != joints.end() && (hand->second - line.back()).norm() > 0.01)
      line.push_back(hand->second);
    const Polyline body_arm(line);
    const double start = body_arm.project_on_first(mean(trunk, x_)) + kBeyond;
    const std::set<int> panels = panels_of(of);
    const Vec3 sideways = axis.cross(outside_[*panels.begin()]).normalized();
    const SleeveMiddle middle(of, placed_, from, axis, sideways);
    for (int v : of) {
      const Vec3 off = placed_[v] - from;
      const double s = off.dot(axis);
      const Polyline::Place at = body_arm.at(start + s - begin);
      Vec3 across = off - s * axis - middle.at(s) * sideways;
      // Panels lie off the line of the arm, each on its side.
      const Vec3& n = outside_[g_.vertex_panel[v]];
      const double depth = across.dot(n);
      if (depth < kFromAxis) across += (kFromAxis - depth) * n;
      x_[v] = at.point + geometry::rotation_between(axis, at.tangent) * across;
    }
    const Vec3 mid = body_arm.at(start + (0 - begin) / 2).tangent;
    for (int k : panels) {
      const RolledPanel rolled(open_, placed_, k, from, axis, outside_[k]);
      if (rolled.goes_round()) {
        rolled.place_clear(body_arm, start - begin, kBeyond, body_, x_);
        outside_[k].setZero();
        continue;
      }
      outside_[k] = geometry::rotation_between(axis, mid) * outside_[k];
      clear_along_normal(k);
    }
  }

  Vec3 sleeve_axis(const std::vector<int>& end, const std::vector<int>& hole) const {
    const Vec3 way = mean(end, placed_) - mean(hole, placed_);
    Vec3 sum = Vec3::Zero();
    for (int k : panels_of(end)) {
      int a = -1, b = -1;
      double longest = 0;
      for (int v : end)
        for (int w : end)
          if (g_.vertex_panel[v] == k && g_.vertex_panel[w] == k &&
              (placed_[v] - placed_[w]).norm() > longest)
            longest = (placed_[v] - placed_[w]).norm(), a = v, b = w;
      if (longest < 0.03) continue;
      Vec3 across = outside_[k].cross(placed_[b] - placed_[a]).normalized();
      if (across.dot(way) < 0) across = -across;
      sum += across;
    }
    if (sum.norm() < 0.5) sum = way;
    return sum.normalized();
  }

  /// Outwards in steps until every vertex is clear of the body.
  void clear_along_normal(int panel) {
    const std::vector<int> of = vertices_of(panel);
    for (int step = 0; step < kSteps; ++step) {
      const bool clear = std::all_of(of.begin(), of.end(), [&](int v) {
        return body_.tree().signed_distance(x_[v], nullptr, 1.0) > kClear;
      });
      if (clear) return;
      for (int v : of) x_[v] += kStep * outside_[panel];
    }
  }

  /// A tube in one piece that is sewn to itself; whether the panel is one.
  bool roll_round_trunk(int panel) {
    const Vec3 middle = mean(vertices_of(panel), x_);
    const RolledPanel tube(open_, x_, panel, middle, Vec3::UnitZ(), outside_[panel]);
    if (!tube.goes_round()) return false;
    const Polyline trunk = trunk_line(limb_lines(body_.body()));
    tube.place_clear(trunk, trunk.project(middle), 0, body_, x_);
    outside_[panel].setZero();
    return true;
  }

  /// Outwards beyond all of the body that lies before the panel. Of one that lies beside the body
  /// the arms are none of its business.
  void clear_trunk(int panel) {
    Mat3 frame = pattern_.panels[pattern_.find_panel(g_.panel_names[panel])].rotation;
    frame.col(2) = outside_[panel];
    const bool beside = std::abs(outside_[panel].y()) < kSideways;
    const auto counts = [&](std::size_t i) { return !(beside && is_of_arm(body_.body(), i)); };
    clear_panel(open_, panel, frame, kClear, body_, counts, x_);
  }

  const garment::Garment& sewn_;
  const garment::OpenSeams& open_;
  const garment::Garment& g_;
  const pattern::Pattern& pattern_;
  const body::PosedBody& body_;
  std::vector<Opening> openings_;
  std::vector<PanelRole> roles_;
  std::vector<int> side_;
  std::map<int, BandRing> bands_;  ///< by panel
  std::vector<int> wrapped_;       ///< panels that are legs in one piece
  std::vector<Vec3> placed_, x_, outside_;
};

}  // namespace

ArrangedPanels arrange_panels(const garment::Garment& sewn, const garment::OpenSeams& open,
                              const pattern::Pattern& pattern, const body::PosedBody& body) {
  return Arranger(sewn, open, pattern, body).arrange();
}

}  // namespace loosefit::drape

#include "loosefit/pattern/place_pieces.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "loosefit/base/error.h"
#include "loosefit/base/text.h"
#include "loosefit/geometry/box.h"
#include "loosefit/pattern/known_one_shoulder.h"
#include "loosefit/pattern/outline.h"
#include "loosefit/pattern/piece_facing.h"
#include "loosefit/pattern/piece_names.h"
#include "loosefit/pattern/sleeve_doubts.h"

namespace loosefit::pattern {
namespace {

constexpr double kBefore = 0.20;        ///< of fronts and backs from the middle [m]
constexpr double kBesideMiddle = 0.25;  ///< of legs in one piece [m]
constexpr double kBesideHead = 0.14;    ///< of halves of a hood [m]
constexpr double kFromMiddle = 0.03;    ///< of pieces of one leg [m]
constexpr double kFromHole = 0.03;      ///< of a sleeve from its armhole [m]
constexpr double kLeastRise = 0.01;     ///< of a seam that tells which way up a piece lies [m]
constexpr double kAtTop = 0.25;         ///< of a garment's height: seams on the shoulders are there
constexpr double kOverNeck = 2.0;       ///< height above everybody's neck [m]

Mat3 about_outside(double angle) {
  return Eigen::AngleAxisd(angle, Vec3::UnitZ()).toRotationMatrix();
}

class Placer {
 public:
  Placer(Pattern& pattern, const QuarterTurns& turns)
      : pattern_(pattern), known_(know_garment(pattern)), turns_(turns), n_(pattern.panels.size()) {
    placed_.assign(n_, 0);
    notes_ = known_.names_against_shapes;
    for (std::string& why : sleeve_doubts(pattern, known_)) notes_.push_back(std::move(why));
    // What is before and what behind is not for the order of a file to say.
    if (known_.unnamed || is_sewn_otherwise()) known_.kind.clear(), known_.pieces.assign(n_, {});
  }

  std::vector<std::string> place() {
    PieceFacings told = tell_facings(pattern_, known_, turns_);
    facing_ = std::move(told.of), half_sleeve_ = std::move(told.half_sleeve);
    if (!told.guessed.empty())
      notes_.push_back(
          "placed beside what they are sewn to, for their names do not say where they go: " +
          join(told.guessed));
    for (std::size_t p = 0; p < n_; ++p) {
      const auto turn = turns_.find(static_cast<int>(p));
      const bool asked = turn != turns_.end();
      pattern_.panels[p].rotation = facing_rotation(facing_[p], asked || known_.pieces[p].upright);
      if (asked)
        pattern_.panels[p].rotation *= about_outside(kPi / 2 * turn->second);
      else if (is_half_of_hood(p))
        stand_on_neck(p);
    }
    lay_first();
    // Whatever is sewn to what lies already, by most seams first; bands last, in the middle of all
    // that they go round.
    while (true) {
      int next = -1, most = 0;
      for (const bool bands : {false, true})
        for (std::size_t p = 0; p < n_ && (next < 0 || !bands); ++p) {
          if (placed_[p] || (known_.pieces[p].role == PieceRole::band) != bands) continue;
          if (const int seams = seams_to_placed(static_cast<int>(p)); seams > most)
            most = seams, next = static_cast<int>(p);
        }
      if (next < 0) break;
      lay_beside_seams(next);
    }
    std::vector<std::string> lost;
    for (std::size_t p = 0; p < n_; ++p)
      if (!placed_[p]) lost.push_back(printable(pattern_.panels[p].name));
    if (!lost.empty())
      throw GeometryError({{}, 0, "pieces"}, "no seam to the others at " + join(lost),
                          "seams that join all pieces",
                          "write the missing seams into the side file, or take these pieces out "
                          "of the pattern there (leave_out)");
    if (hangs_on_shoulders()) lift_to(kOverNeck);
    set_labels();
    if (known_.kind.starts_with(kOneShoulder)) label_armhole();
    return std::move(notes_);
  }

 private:
  /// Whether most seams between pieces that are known are others than those of the known garment,
  /// which the outlines of short trousers suggest the wrong way up.
  bool is_sewn_otherwise() const {
    std::size_t judged = 0, other = 0;
    const auto has = [](const std::vector<Stitch::Side>& run, const Stitch::Side& side) {
      return std::ranges::any_of(run, [&](const Stitch::Side& of) {
        return of.panel == side.panel && of.edge == side.edge;
      });
    };
    for (const Stitch& stitch : pattern_.stitches) {
      if (known_.pieces[stitch.first.panel].role == PieceRole::unknown ||
          known_.pieces[stitch.second.panel].role == PieceRole::unknown)
        continue;
      ++judged;
      other += std::ranges::none_of(known_.seams, [&](const ChainSeam& seam) {
        return (has(seam.first, stitch.first) && has(seam.second, stitch.second)) ||
               (has(seam.first, stitch.second) && has(seam.second, stitch.first));
      });
    }
    return 2 * other > judged;
  }

  int seams_to_placed(int panel) const {
    int count = 0;
    for (const Stitch& stitch : pattern_.stitches)
      if (const auto* other = other_side(stitch, panel)) count += placed_[other->panel];
    return count;
  }

  Vec3 middle_of(const Stitch::Side& side) const {
    const Panel& panel = pattern_.panels[side.panel];
    const Vec2 at = EdgePath(panel, side.edge).at(0.5);
    return panel.rotation * Vec3(at.x(), at.y(), 0) + panel.translation;
  }

  geometry::Box3 box_of(int p) const {
    geometry::Box3 box;
    const Panel& panel = pattern_.panels[p];
    for (const Vec2& q : outline_polygon(panel, 8))
      box.extend(Vec3(panel.rotation * Vec3(q.x(), q.y(), 0) + panel.translation));
    return box;
  }

  bool is_leg(int p) const {
    const PieceRole role = known_.pieces[p].role;
    return role == PieceRole::front_leg || role == PieceRole::back_leg || role == PieceRole::leg;
  }

  bool is_half_of_hood(std::size_t p) const {
    return known_.pieces[p].role == PieceRole::hood && known_.pieces[p].side != 0;
  }

  /// Turns half of a hood in its plane until its neck lies below it.
  void stand_on_neck(std::size_t p) {
    const Section& neck = known_.pieces[p].sections.front();
    const Vec2 along = neck.to - neck.from;
    pattern_.panels[p].rotation *= about_outside(-std::atan2(along.y(), along.x()));
  }

  /// Where a piece goes that is before or behind: its distance, and beside the middle what is for
  /// one side.
  void lay_flat(int p, double x, double z) {
    Panel& panel = pattern_.panels[p];
    if (facing_[p] == Facing::left_side || facing_[p] == Facing::right_side) {
      const geometry::Box3 box = box_of(p);
      const bool of_hood = is_half_of_hood(p) || is_named_half_of_hood(pattern_, known_, p);
      const double beside = of_hood ? kBesideHead : kBesideMiddle;
      panel.translation = Vec3(facing_[p] == Facing::left_side ? beside : -beside,
                               -0.5 * (box.min().y() + box.max().y()) + panel.translation.y(), z);
      placed_[p] = 1;
      return;
    }
    panel.translation = Vec3(x, facing_[p] == Facing::back ? kBefore : -kBefore, z);
    const int side = is_leg(p) ? known_.pieces[p].side : side_by_name(p);
    const geometry::Box3 box = box_of(p);
    if (side > 0) panel.translation.x() += std::max(0.0, kFromMiddle - box.min().x());
    if (side < 0) panel.translation.x() -= std::max(0.0, box.max().x() + kFromMiddle);
    placed_[p] = 1;
  }

  int side_by_name(int p) const {
    if (known_.pieces[p].role != PieceRole::unknown) return 0;
    const PieceWords w = words_of(pattern_.panels[p]);
    return w.left ? 1 : w.right ? -1 : 0;
  }

  /// The largest front, else the largest back, stands in the middle.
  void lay_first() {
    int first = -1;
    double largest = 0;
    for (const Facing facing : {Facing::front, Facing::back, Facing::left_side}) {
      for (std::size_t p = 0; p < n_ && (first < 0 || facing == facing_[first]); ++p) {
        if (facing_[p] != facing) continue;
        const double area = signed_area(outline_polygon(pattern_.panels[p], 8));
        if (area > largest) largest = area, first = static_cast<int>(p);
      }
      if (first >= 0) break;
    }
    pattern_.panels[first].translation = Vec3::Zero();
    const geometry::Box3 box = box_of(first);
    lay_flat(first, -0.5 * (box.min().x() + box.max().x()), -box.min().z());
  }

  /// A piece that nothing tells which way up it lies, such as a band drawn upright: turned in its
  /// plane until its seams lie along those of its neighbours in that plane; of one beside the body,
  /// which lies in a plane of its own, along those of all neighbours.
  void turn_to_seams(int p) {
    Panel& panel = pattern_.panels[p];
    const bool beside = facing_[p] == Facing::left_side || facing_[p] == Facing::right_side;
    std::vector<Vec2> own, target;
    for (const Stitch& stitch : pattern_.stitches) {
      const auto* other = other_side(stitch, p);
      if (!other || !placed_[other->panel]) continue;
      if (facing_[other->panel] != facing_[p] && !beside) continue;
      const Stitch::Side& side = stitch.first.panel == p ? stitch.first : stitch.second;
      const Panel& neighbour = pattern_.panels[other->panel];
      const EdgePath path(panel, side.edge), along(neighbour, other->edge);
      for (const double t : {0.0, 0.5, 1.0}) {
        const Vec2 q = along.at(stitch.right_wrong ? t : 1 - t);
        const Vec3 at = panel.rotation.transpose() *
                        (neighbour.rotation * Vec3(q.x(), q.y(), 0) + neighbour.translation);
        own.push_back(path.at(t));
        target.emplace_back(at.x(), at.y());
      }
    }
    if (own.empty()) return stand_like_neighbours(p);
    // The turn of least squares (Kabsch 1976, in the plane).
    Vec2 a = Vec2::Zero(), b = Vec2::Zero();
    for (std::size_t i = 0; i < own.size(); ++i) a += own[i], b += target[i];
    a /= static_cast<double>(own.size()), b /= static_cast<double>(own.size());
    double dot = 0, cross = 0;
    for (std::size_t i = 0; i < own.size(); ++i) {
      const Vec2 u = own[i] - a, v = target[i] - b;
      dot += u.dot(v), cross += u.x() * v.y() - u.y() * v.x();
    }
    if (std::hypot(dot, cross) < 1e-8) return;
    double turn = std::atan2(cross, dot);
    // Fronts and backs stand farther apart than they will be worn, and crotches of two halves slant
    // away from each other: that tilts nothing.
    const PieceWords w = words_of(panel);
    const bool stands = (w.front || w.back) && !(w.sleeve || w.cuff || w.neck || w.hood || w.yoke ||
                                                 w.pocket || w.waist || w.hem);
    if (beside || stands) turn = kPi / 2 * std::round(turn / (kPi / 2));
    panel.rotation *= about_outside(turn);
  }

  /// A back may lie on its head in the file and its front upright: seams of the two that run up on
  /// one side and down on the other turn it over its head.
  void stand_like_neighbours(int p) {
    Panel& panel = pattern_.panels[p];
    const auto faces_to_or_fro = [&](int piece) {
      return facing_[piece] == Facing::front || facing_[piece] == Facing::back;
    };
    if (known_.pieces[p].role != PieceRole::unknown || !faces_to_or_fro(p)) return;
    const auto rise = [&](const Stitch::Side& side) {
      const EdgePath path(pattern_.panels[side.panel], side.edge);
      const Vec2 way = path.at(1) - path.at(0);
      return (pattern_.panels[side.panel].rotation * Vec3(way.x(), way.y(), 0)).z();
    };
    double agreement = 0;
    for (const Stitch& stitch : pattern_.stitches) {
      const auto* other = other_side(stitch, p);
      if (!other || !placed_[other->panel] || !faces_to_or_fro(other->panel)) continue;
      const double product =
          rise(stitch.first.panel == p ? stitch.first : stitch.second) * rise(*other);
      agreement += stitch.right_wrong ? product : -product;
    }
    if (agreement < -kLeastRise * kLeastRise) panel.rotation *= about_outside(kPi);
  }

  void lay_beside_seams(int p) {
    Panel& panel = pattern_.panels[p];
    const PieceRole role = known_.pieces[p].role;
    if (!turns_.contains(p) &&
        (role == PieceRole::unknown || role == PieceRole::band || role == PieceRole::half_sleeve ||
         (role == PieceRole::hood && !is_half_of_hood(p))))
      turn_to_seams(p);
    panel.translation = Vec3::Zero();
    Vec3 sum = Vec3::Zero(), target = Vec3::Zero();
    int count = 0;
    for (const Stitch& stitch : pattern_.stitches) {
      const auto* other = other_side(stitch, p);
      if (!other || !placed_[other->panel]) continue;
      const Stitch::Side& own = stitch.first.panel == p ? stitch.first : stitch.second;
      target += middle_of(*other);
      sum += middle_of(own);
      ++count;
    }
    const Vec3 shift = (target - sum) / count;
    const Facing facing = facing_[p];
    if (facing == Facing::left_arm || facing == Facing::right_arm) {
      const Vec3 along = -facing_rotation(facing, true).col(1);
      panel.translation = shift + kFromHole * along;
      placed_[p] = 1;
    } else {
      lay_flat(p, shift.x(), shift.z());
    }
  }

  /// Of a tabard or poncho: fronts and backs that are sewn to each other at their tops alone. Its
  /// opening there is a neck, and nobody's waist.
  bool hangs_on_shoulders() const {
    if (!known_.kind.empty()) return false;
    double low = HUGE_VAL, high = -HUGE_VAL, lowest_seam = HUGE_VAL;
    for (std::size_t p = 0; p < n_; ++p) {
      const PieceWords w = words_of(pattern_.panels[p]);
      if (w.leg || w.skirt || w.waist ||
          (facing_[p] != Facing::front && facing_[p] != Facing::back))
        return false;
      const geometry::Box3 box = box_of(static_cast<int>(p));
      low = std::min(low, box.min().z()), high = std::max(high, box.max().z());
    }
    for (const Stitch& stitch : pattern_.stitches) {
      if (facing_[stitch.first.panel] == facing_[stitch.second.panel]) continue;
      for (const Stitch::Side& side : {stitch.first, stitch.second}) {
        const Panel& panel = pattern_.panels[side.panel];
        const EdgePath path(panel, side.edge);
        for (const double t : {0.0, 0.5, 1.0}) {
          const Vec2 q = path.at(t);
          const Vec3 at = panel.rotation * Vec3(q.x(), q.y(), 0) + panel.translation;
          lowest_seam = std::min(lowest_seam, at.z());
        }
      }
    }
    return std::isfinite(lowest_seam) && lowest_seam > high - kAtTop * (high - low);
  }

  /// Raises all pieces until the highest comes there.
  void lift_to(double top) {
    double high = -HUGE_VAL;
    for (std::size_t p = 0; p < n_; ++p)
      high = std::max(high, box_of(static_cast<int>(p)).max().z());
    for (Panel& panel : pattern_.panels) panel.translation.z() += top - high;
  }

  void set_labels() {
    for (std::size_t p = 0; p < n_; ++p) {
      if (!pattern_.panels[p].label.empty()) continue;
      const bool arm =
          half_sleeve_[p] || facing_[p] == Facing::left_arm || facing_[p] == Facing::right_arm;
      // A band at an armhole is of the arm, which its seams tell where its label does not.
      if (known_.pieces[p].role == PieceRole::band && !arm) continue;
      pattern_.panels[p].label = arm ? "arm" : is_leg(static_cast<int>(p)) ? "leg" : "body";
    }
  }

  /// Whether a garment that hangs on one shoulder is worn, its armhole tells.
  void label_armhole() {
    for (std::size_t p = 0; p < n_; ++p) {
      const KnownPiece& piece = known_.pieces[p];
      if (piece.role != PieceRole::front && piece.role != PieceRole::back) continue;
      const int armhole = piece.sections[2].length < piece.sections[4].length ? 2 : 4;
      const bool left = (armhole == 2) == (piece.role == PieceRole::front);
      for (const Stitch::Side& side :
           piece.sections[armhole].sides(pattern_.panels[p], static_cast<int>(p)))
        if (std::string& label = pattern_.panels[p].edges[side.edge].label; label.empty())
          label = left ? "left_armhole" : "right_armhole";
    }
  }

  Pattern& pattern_;
  KnownGarment known_;
  const QuarterTurns& turns_;
  std::size_t n_;
  std::vector<Facing> facing_;
  std::vector<char> half_sleeve_, placed_;
  std::vector<std::string> notes_;
};

}  // namespace

std::vector<std::string> place_pieces(Pattern& pattern, const QuarterTurns& turns) {
  return Placer(pattern, turns).place();
}

}  // namespace loosefit::pattern

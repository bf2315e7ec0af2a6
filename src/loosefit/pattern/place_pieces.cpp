#include "loosefit/pattern/place_pieces.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "loosefit/base/error.h"
#include "loosefit/base/text.h"
#include "loosefit/geometry/box.h"
#include "loosefit/pattern/outline.h"
#include "loosefit/pattern/piece_names.h"

namespace loosefit::pattern {
namespace {

constexpr double kBefore = 0.20;        ///< of fronts and backs from the middle [m]
constexpr double kBesideMiddle = 0.25;  ///< of legs in one piece [m]
constexpr double kBesideHead = 0.14;    ///< of halves of a hood [m]
constexpr double kFromMiddle = 0.03;    ///< of pieces of one leg [m]
constexpr double kArmDown = 0.7;        ///< of arms below the horizontal [rad]
constexpr double kFromHole = 0.03;      ///< of a sleeve from its armhole [m]
constexpr double kLeastRise = 0.01;     ///< of a seam that tells which way up a piece lies [m]

/// The way a piece faces.
enum class Facing { unknown, front, back, left_side, right_side, left_arm, right_arm };

Mat3 facing_rotation(Facing facing, bool upright) {
  Mat3 r;
  const double c = std::cos(kArmDown), s = std::sin(kArmDown);
  switch (facing) {
    case Facing::back:
      r.col(1) = Vec3::UnitZ();
      r.col(2) = Vec3::UnitY();
      break;
    case Facing::left_side:
      r.col(1) = Vec3::UnitZ();
      r.col(2) = Vec3::UnitX();
      break;
    case Facing::right_side:
      r.col(1) = Vec3::UnitZ();
      r.col(2) = -Vec3::UnitX();
      break;
    case Facing::left_arm:
      r.col(1) = Vec3(-c, 0, s);
      r.col(2) = Vec3(s, 0, c);
      break;
    case Facing::right_arm:
      r.col(1) = Vec3(c, 0, s);
      r.col(2) = Vec3(-s, 0, c);
      break;
    default:
      r.col(1) = Vec3::UnitZ();
      r.col(2) = -Vec3::UnitY();
  }
  if (!upright) r.col(1) = -r.col(1);
  r.col(0) = r.col(1).cross(r.col(2));
  return r;
}

class Placer {
 public:
  explicit Placer(Pattern& pattern)
      : pattern_(pattern), known_(know_garment(pattern)), n_(pattern.panels.size()) {
    facing_.assign(n_, Facing::unknown);
    placed_.assign(n_, 0);
  }

  std::vector<std::string> place() {
    tell_facing();
    for (std::size_t p = 0; p < n_; ++p) {
      pattern_.panels[p].rotation = facing_rotation(facing_[p], known_.pieces[p].upright);
      if (is_half_of_hood(p)) stand_on_neck(p);
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
      throw GeometryError({{}, 0, "pieces"}, "pieces that are sewn to no other one: " + join(lost),
                          "seams that join all pieces",
                          "write the missing seams into the side file (--propose-seams helps), or "
                          "take these pieces out of the pattern");
    set_labels();
    return std::move(notes_);
  }

 private:
  /// Sleeves go to the side to which their name or what they are says; what nothing is said of goes
  /// where its neighbours are.
  void tell_facing() {
    std::vector<std::string> guessed;
    for (std::size_t p = 0; p < n_; ++p) {
      const KnownPiece& piece = known_.pieces[p];
      switch (piece.role) {
        case PieceRole::front:
        case PieceRole::front_leg:
        case PieceRole::front_skirt:
          facing_[p] = Facing::front;
          break;
        case PieceRole::back:
        case PieceRole::back_leg:
        case PieceRole::back_skirt:
          facing_[p] = Facing::back;
          break;
        case PieceRole::leg:
          facing_[p] = piece.side > 0 ? Facing::left_side : Facing::right_side;
          break;
        case PieceRole::hood:
          facing_[p] = piece.side > 0   ? Facing::left_side
                       : piece.side < 0 ? Facing::right_side
                                        : Facing::back;
          break;
        case PieceRole::sleeve: {
          // Of a garment that is not known the name may tell the side.
          const bool left =
              piece.side == 0 ? words_of(pattern_.panels[p].name).left : piece.side > 0;
          facing_[p] = left ? Facing::left_arm : Facing::right_arm;
          break;
        }
        case PieceRole::band:  // with what it is sewn to
        case PieceRole::unknown: {
          const Panel& panel = pattern_.panels[p];
          const PieceWords w = words_of(panel.name);
          if (w.sleeve || w.cuff || panel.label == "arm") {
            if (w.left) facing_[p] = Facing::left_arm;
            if (w.right) facing_[p] = Facing::right_arm;
          } else if (w.front) {
            facing_[p] = Facing::front;
          } else if (w.back) {
            facing_[p] = Facing::back;
          }
        }
      }
    }
    if (std::none_of(facing_.begin(), facing_.end(), [](Facing f) {
          return f == Facing::front || f == Facing::back || f == Facing::left_side;
        }))
      throw GeometryError({{}, 0, "pieces"}, "no piece that is told to be a front or a back",
                          "names such as front and back",
                          "name the pieces, or give the file a placement (GarmentCode JSON)");
    // Of the rest each follows the neighbour with the longest seam, one after the other.
    for (bool grown = true; grown;) {
      grown = false;
      for (std::size_t p = 0; p < n_; ++p) {
        if (facing_[p] != Facing::unknown) continue;
        double longest = 0;
        Facing like = Facing::unknown;
        for (const Stitch& stitch : pattern_.stitches) {
          const auto other = other_side(stitch, static_cast<int>(p));
          if (!other || facing_[other->panel] == Facing::unknown) continue;
          const double length = EdgePath(pattern_.panels[other->panel], other->edge).length();
          if (length > longest) longest = length, like = facing_[other->panel];
        }
        if (like == Facing::unknown) continue;
        facing_[p] = like;
        if (known_.pieces[p].role != PieceRole::band)
          guessed.push_back(printable(pattern_.panels[p].name));
        grown = true;
      }
    }
    if (!guessed.empty())
      notes_.push_back(
          "placed beside what they are sewn to, for their names do not say where they "
          "go: " +
          join(guessed));
  }

  const Stitch::Side* other_side(const Stitch& stitch, int panel) const {
    if (stitch.first.panel == panel && stitch.second.panel != panel) return &stitch.second;
    if (stitch.second.panel == panel && stitch.first.panel != panel) return &stitch.first;
    return nullptr;
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
    pattern_.panels[p].rotation *=
        Eigen::AngleAxisd(-std::atan2(along.y(), along.x()), Vec3::UnitZ()).toRotationMatrix();
  }

  /// Where a piece goes that is before or behind: its distance, and beside the middle what is for
  /// one side.
  void lay_flat(int p, double x, double z) {
    Panel& panel = pattern_.panels[p];
    if (facing_[p] == Facing::left_side || facing_[p] == Facing::right_side) {
      const geometry::Box3 box = box_of(p);
      const double beside = is_half_of_hood(p) ? kBesideHead : kBesideMiddle;
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
    const PieceWords w = words_of(pattern_.panels[p].name);
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
  /// plane until its seams lie along those of its neighbours in that plane.
  void turn_to_seams(int p) {
    Panel& panel = pattern_.panels[p];
    std::vector<Vec2> own, target;
    for (const Stitch& stitch : pattern_.stitches) {
      const auto* other = other_side(stitch, p);
      if (!other || !placed_[other->panel] || facing_[other->panel] != facing_[p]) continue;
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
    panel.rotation *= Eigen::AngleAxisd(std::atan2(cross, dot), Vec3::UnitZ()).toRotationMatrix();
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
    if (agreement < -kLeastRise * kLeastRise)
      panel.rotation *= Eigen::AngleAxisd(kPi, Vec3::UnitZ()).toRotationMatrix();
  }

  void lay_beside_seams(int p) {
    Panel& panel = pattern_.panels[p];
    const PieceRole role = known_.pieces[p].role;
    if (role == PieceRole::unknown || role == PieceRole::band ||
        (role == PieceRole::hood && !is_half_of_hood(p)))
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

  void set_labels() {
    for (std::size_t p = 0; p < n_; ++p) {
      if (!pattern_.panels[p].label.empty()) continue;
      const bool arm = facing_[p] == Facing::left_arm || facing_[p] == Facing::right_arm;
      // A band at an armhole is of the arm, which its seams tell where its label does not.
      if (known_.pieces[p].role == PieceRole::band && !arm) continue;
      pattern_.panels[p].label = arm ? "arm" : is_leg(static_cast<int>(p)) ? "leg" : "body";
    }
  }

  Pattern& pattern_;
  KnownGarment known_;
  std::size_t n_;
  std::vector<Facing> facing_;
  std::vector<char> placed_;
  std::vector<std::string> notes_;
};

}  // namespace

std::vector<std::string> place_pieces(Pattern& pattern) { return Placer(pattern).place(); }

}  // namespace loosefit::pattern

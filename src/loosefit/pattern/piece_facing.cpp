#include "loosefit/pattern/piece_facing.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>

#include "loosefit/base/error.h"
#include "loosefit/base/text.h"
#include "loosefit/pattern/outline.h"
#include "loosefit/pattern/piece_names.h"

namespace loosefit::pattern {
namespace {

constexpr double kArmDown = 0.7;    ///< of arms below the horizontal [rad]
constexpr double kBothAlike = 0.5;  ///< of the shorter of a side's seams to front and back

bool is_front_or_back(Facing facing) { return facing == Facing::front || facing == Facing::back; }

class Teller {
 public:
  Teller(const Pattern& pattern, const KnownGarment& known, const QuarterTurns& turns)
      : pattern_(pattern), known_(known), turns_(turns), n_(pattern.panels.size()) {
    result_.of.assign(n_, Facing::unknown);
    result_.half_sleeve.assign(n_, 0);
  }

  PieceFacings tell() {
    for (std::size_t p = 0; p < n_; ++p) result_.half_sleeve[p] = is_half_sleeve(p);
    for (std::size_t p = 0; p < n_; ++p) result_.of[p] = told_by_itself(p);
    if (std::none_of(result_.of.begin(), result_.of.end(),
                     [](Facing f) { return is_front_or_back(f) || f == Facing::left_side; }))
      throw GeometryError({{}, 0, "pieces"}, "no piece that is told to be a front or a back",
                          "names such as front and back",
                          "name the pieces, or say in the side file what they are: [pieces] with " +
                              printable(pattern_.panels.front().name, 60) +
                              " = \"front\" and so on");
    for (std::size_t p = 0; p < n_; ++p)
      if (result_.half_sleeve[p] && result_.of[p] == Facing::unknown)
        result_.of[p] = as_trunk_neighbour(p);
    for (std::size_t p = 0; p < n_; ++p)
      if (result_.of[p] == Facing::unknown) result_.of[p] = as_arm(p);
    for (std::size_t p = 0; p < n_; ++p)
      if (result_.of[p] == Facing::unknown) result_.of[p] = as_side(p);
    follow_neighbours();
    return std::move(result_);
  }

 private:
  PieceWords words(std::size_t p) const { return words_of(pattern_.panels[p]); }

  bool is_of_sleeve(std::size_t p) const {
    const PieceRole role = known_.pieces[p].role;
    if (role == PieceRole::half_sleeve) return true;
    if (role != PieceRole::unknown) return false;
    const PieceWords w = words(p);
    return w.sleeve || w.cuff || pattern_.panels[p].label == "arm";
  }

  bool is_half_sleeve(std::size_t p) const {
    if (!is_of_sleeve(p)) return false;
    bool other_half = false;
    for (const Stitch& stitch : pattern_.stitches) {
      const int panel = static_cast<int>(p);
      if (stitch.first.panel == panel && stitch.second.panel == panel) return false;
      if (const auto* other = other_side(stitch, panel))
        other_half =
            other_half || (is_of_sleeve(other->panel) && words(other->panel).cuff == words(p).cuff);
    }
    return other_half;
  }

  Facing told_by_itself(std::size_t p) const {
    const KnownPiece& piece = known_.pieces[p];
    const PieceWords w = words(p);
    const auto beside = [](int side) { return side > 0 ? Facing::left_side : Facing::right_side; };
    switch (piece.role) {
      case PieceRole::front:
      case PieceRole::front_leg:
      case PieceRole::front_skirt:
        return Facing::front;
      case PieceRole::back:
      case PieceRole::back_leg:
      case PieceRole::back_skirt:
        return Facing::back;
      case PieceRole::leg:
      case PieceRole::side_skirt:
        return beside(piece.side);
      case PieceRole::hood:
        return piece.side == 0 ? Facing::back : beside(piece.side);
      case PieceRole::sleeve:
        // Of a garment that is not known the name may tell the side, or the armhole.
        if (piece.side == 0 && !w.left && !w.right) return Facing::unknown;
        return (piece.side == 0 ? w.left : piece.side > 0) ? Facing::left_arm : Facing::right_arm;
      case PieceRole::half_sleeve:
      case PieceRole::band:  // with what it is sewn to
      case PieceRole::unknown:
        break;
    }
    if (is_named_half_of_hood(pattern_, known_, static_cast<int>(p)))
      return beside(w.left ? 1 : -1);
    if (!result_.half_sleeve[p] && (w.sleeve || w.cuff || pattern_.panels[p].label == "arm")) {
      return w.left ? Facing::left_arm : w.right ? Facing::right_arm : Facing::unknown;
    }
    return w.front ? Facing::front : w.back ? Facing::back : Facing::unknown;
  }

  /// Lengths of the seams to neighbours, by what these face.
  std::map<Facing, double> seams_by_facing(std::size_t p) const {
    std::map<Facing, double> sum;
    for (const Stitch& stitch : pattern_.stitches)
      if (const auto* other = other_side(stitch, static_cast<int>(p)))
        sum[result_.of[other->panel]] +=
            EdgePath(pattern_.panels[other->panel], other->edge).length();
    return sum;
  }

  Facing as_trunk_neighbour(std::size_t p) const {
    double longest = 0;
    Facing like = Facing::unknown;
    for (const Stitch& stitch : pattern_.stitches) {
      const auto* other = other_side(stitch, static_cast<int>(p));
      if (!other || is_of_sleeve(other->panel) || !is_front_or_back(result_.of[other->panel]))
        continue;
      const double length = EdgePath(pattern_.panels[other->panel], other->edge).length();
      if (length > longest) longest = length, like = result_.of[other->panel];
    }
    return like;
  }

  /// A sleeve in one piece goes along the arm of its armhole: that on the left of the wearer is
  /// right of the middle of a front, seen from outside, and left of that of a back.
  Facing as_arm(std::size_t p) const {
    const PieceRole role = known_.pieces[p].role;
    if (role != PieceRole::sleeve && (!is_of_sleeve(p) || result_.half_sleeve[p]))
      return Facing::unknown;
    double left = 0;
    for (const Stitch& stitch : pattern_.stitches) {
      const auto* other = other_side(stitch, static_cast<int>(p));
      if (!other || !is_front_or_back(result_.of[other->panel]) || is_of_sleeve(other->panel))
        continue;
      const Panel& trunk = pattern_.panels[other->panel];
      const EdgePath edge(trunk, other->edge);
      Eigen::AlignedBox2d box;
      for (const Vec2& q : outline_polygon(trunk, 4)) box.extend(q);
      Vec2 off = edge.at(0.5) - box.center();
      const auto turn = turns_.find(other->panel);
      for (int i = 0; turn != turns_.end() && i < turn->second; ++i) off = Vec2(-off.y(), off.x());
      const bool seen_right = off.x() > 0;
      const bool turned = turn == turns_.end() && !known_.pieces[other->panel].upright;
      const bool on_left = seen_right == (result_.of[other->panel] == Facing::front);
      left += (on_left != turned ? 1 : -1) * edge.length();
    }
    return left > 0 ? Facing::left_arm : left < 0 ? Facing::right_arm : Facing::unknown;
  }

  Facing as_side(std::size_t p) const {
    if (known_.pieces[p].role != PieceRole::unknown || is_of_sleeve(p)) return Facing::unknown;
    const PieceWords w = words(p);
    if (w.left == w.right || w.neck || w.waist || w.hem || w.yoke || w.pocket || w.hood)
      return Facing::unknown;
    const auto sum = seams_by_facing(p);
    const auto of = [&](Facing f) { return sum.contains(f) ? sum.at(f) : 0.0; };
    const double front = of(Facing::front), back = of(Facing::back);
    if (std::min(front, back) <= kBothAlike * std::max(front, back)) return Facing::unknown;
    return w.left ? Facing::left_side : Facing::right_side;
  }

  void follow_neighbours() {
    for (bool grown = true; grown;) {
      grown = false;
      for (std::size_t p = 0; p < n_; ++p) {
        if (result_.of[p] != Facing::unknown) continue;
        double longest = 0;
        Facing like = Facing::unknown;
        for (const Stitch& stitch : pattern_.stitches) {
          const auto* other = other_side(stitch, static_cast<int>(p));
          if (!other || result_.of[other->panel] == Facing::unknown) continue;
          const double length = EdgePath(pattern_.panels[other->panel], other->edge).length();
          if (length > longest) longest = length, like = result_.of[other->panel];
        }
        if (like == Facing::unknown) continue;
        result_.of[p] = like;
        if (known_.pieces[p].role != PieceRole::band && !result_.half_sleeve[p])
          result_.guessed.push_back(printable(pattern_.panels[p].name));
        grown = true;
      }
    }
  }

  const Pattern& pattern_;
  const KnownGarment& known_;
  const QuarterTurns& turns_;
  std::size_t n_;
  PieceFacings result_;
};

}  // namespace

const Stitch::Side* other_side(const Stitch& stitch, int panel) {
  if (stitch.first.panel == panel && stitch.second.panel != panel) return &stitch.second;
  if (stitch.second.panel == panel && stitch.first.panel != panel) return &stitch.first;
  return nullptr;
}

bool is_named_half_of_hood(const Pattern& pattern, const KnownGarment& known, int panel) {
  const PieceWords w = words_of(pattern.panels[panel]);
  return known.pieces[panel].role == PieceRole::unknown && w.hood && w.left != w.right;
}

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

PieceFacings tell_facings(const Pattern& pattern, const KnownGarment& known,
                          const QuarterTurns& turns) {
  return Teller(pattern, known, turns).tell();
}

}  // namespace loosefit::pattern

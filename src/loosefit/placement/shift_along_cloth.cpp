#include "loosefit/placement/shift_along_cloth.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "loosefit/geometry/flat_triangle.h"
#include "loosefit/placement/footprint_unfold.h"

namespace loosefit::placement {
namespace {

constexpr double kLineSlack = 1e-4;  // [m]
/// Share of an edge, or of a triangle, by which the line keeps off corners and off the edge on
/// which it starts: then it is never undecided which triangle comes next.
constexpr double kOff = 1e-11;

/// A straight line that is drawn over the flat cloth.
class StraightLine {
 public:
  StraightLine(const garment::Garment& garment, const GarmentPoint& from, const Vec2& shift)
      : garment_(garment),
        neighbours_(triangle_neighbours(garment)),
        triangle_(from.triangle),
        weights_((1 - kOff) * from.barycentric + Vec3::Constant(kOff / 3)),
        direction_(shift.normalized()),
        left_(shift.norm()) {}

  std::optional<ShiftedPoint> end() {
    // At a sharp corner it could slide to and fro for ever.
    for (std::size_t step = 0; step < 2 * garment_.triangles.size() + 2; ++step) {
      if (!sliding_ && !cross_triangle()) return here();
      const int k = (out_ + 1) % 3, next = neighbours_[triangle_][k];
      if (next >= 0) {
        enter(next, across_edge(garment_, triangle_, k, next), k);
        continue;
      }
      slide();
      if (outside_ > kLineSlack) return std::nullopt;
      if (left_ <= 0) return here();
    }
    return std::nullopt;
  }

 private:
  /// To the edge by which the line leaves its triangle; false where it ends before.
  bool cross_triangle() {
    const auto& uv = garment_.triangle_uv[triangle_];
    const Vec3 rate = weights_in(uv, uv[0] + direction_) - Vec3::UnitX();
    double way = left_;
    out_ = -1;
    // A straight line does not leave by the edge by which it came, whatever round-off says.
    for (int k = 0; k < 3; ++k) {
      if (k == came_by_ || !(rate[k] < 0)) continue;
      const double to_edge = std::max(0.0, weights_[k]) / -rate[k];
      if (to_edge < way) way = to_edge, out_ = k;
    }
    weights_ += way * rate;
    left_ -= way;
    if (out_ < 0) return false;
    const int a = (out_ + 1) % 3, b = (out_ + 2) % 3;
    put_on_edge(a, b, weights_[b] / (weights_[a] + weights_[b]));
    return true;
  }

  /// At this share of the edge from corner a to b, and off both.
  void put_on_edge(int a, int b, double share) {
    share = std::clamp(share, kOff, 1 - kOff);
    weights_.setZero();
    weights_[a] = 1 - share;
    weights_[b] = share;
  }

  void enter(int next, const AcrossEdge& across, int k) {
    Vec3 there = Vec3::Zero();
    there[across.ends[0]] = weights_[k];
    there[across.ends[1]] = weights_[(k + 1) % 3];
    weights_ = there;
    came_by_ = 3 - across.ends[0] - across.ends[1];
    direction_ = across.turn.transpose() * direction_;
    turn_ = across.turn.transpose() * turn_;
    triangle_ = next;
    sliding_ = false;
  }

  /// Beside a line that has left the cloth, along the free edge: to the end of the line, or to the
  /// next corner, and there to the other edge of the triangle.
  void slide() {
    const int a = (out_ + 1) % 3, b = (out_ + 2) % 3;
    const auto& uv = garment_.triangle_uv[triangle_];
    const double length = (uv[b] - uv[a]).norm();
    const Vec2 edge = (uv[b] - uv[a]) / length;
    const double along = direction_.dot(edge);
    const double room = (along > 0 ? weights_[a] : weights_[b]) * length;
    const double way = std::min(left_, room / std::max(std::abs(along), kOff));
    outside_ += way * std::abs(geometry::cross(direction_, edge));
    left_ -= way;
    if (left_ <= 0) {
      put_on_edge(a, b, weights_[b] + way * along / length);
      return;
    }
    const int ahead = along > 0 ? b : a, apex = out_;
    out_ = along > 0 ? a : b;
    put_on_edge(ahead, apex, 0);
    sliding_ = true;
  }

  ShiftedPoint here() const {
    const Vec3 inside = weights_.cwiseMax(0);
    ShiftedPoint end;
    end.point = {triangle_, inside / inside.sum()};
    end.mirrored = turn_.determinant() < 0;
    // Of a reflection what is left once u is turned round.
    const double sign = end.mirrored ? -1 : 1;
    end.turn = std::atan2(sign * turn_(1, 0), sign * turn_(0, 0));
    return end;
  }

  const garment::Garment& garment_;
  TriangleNeighbours neighbours_;
  int triangle_;
  Vec3 weights_;  ///< where it has come to in its triangle
  Vec2 direction_;
  double left_;                   ///< of its length [m]
  Mat2 turn_ = Mat2::Identity();  ///< from directions at the start to those here
  int came_by_ = -1;              ///< corner opposite to the edge
  int out_ = -1;                  ///< the same of the edge by which it leaves
  bool sliding_ = false;          ///< it is on that edge already
  double outside_ = 0;            ///< how far the line lies beside the cloth [m]
};

}  // namespace

double ShiftedPoint::angle(double at_start) const {
  if (turn == 0 && !mirrored) return at_start;
  return std::remainder((mirrored ? -at_start : at_start) + turn, 2 * kPi);
}

std::optional<ShiftedPoint> shifted(const garment::Garment& garment, const GarmentPoint& point,
                                    const Vec2& shift) {
  if (shift.isZero()) return ShiftedPoint{point};
  return StraightLine(garment, point, shift).end();
}

}  // namespace loosefit::placement

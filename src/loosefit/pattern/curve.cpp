#include "loosefit/pattern/curve.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace loosefit::pattern {
namespace {

struct Arc {
  Vec2 centre;
  double radius, start, turn;  // angle at t = 0 and signed angle run through [rad]
};

Arc arc_of(const EdgeCurve& curve, const Vec2& a, const Vec2& b) {
  const Vec2 chord = b - a;
  const double length = chord.norm();
  // A radius below half the chord is enlarged until the arc reaches both ends (SVG 1.1 F.6.6).
  const double radius = std::max(curve.radius, length / 2);
  const double h = std::sqrt(std::max(radius * radius - length * length / 4, 0.0));
  const double side = curve.large_arc != curve.sweep ? 1 : -1;
  const Vec2 left = length > 0 ? Vec2(Vec2(-chord.y(), chord.x()) / length) : Vec2(0, 1);
  Arc arc{(a + b) / 2 + side * h * left, radius, 0, 0};
  const Vec2 from = a - arc.centre, to = b - arc.centre;
  arc.start = std::atan2(from.y(), from.x());
  arc.turn = std::atan2(to.y(), to.x()) - arc.start;
  if (curve.sweep && arc.turn < 0) arc.turn += 2 * kPi;
  if (!curve.sweep && arc.turn > 0) arc.turn -= 2 * kPi;
  return arc;
}

constexpr std::array<double, 5> kGaussNode{0, 0.5384693101056831, -0.5384693101056831,
                                           0.9061798459386640, -0.9061798459386640};
constexpr std::array<double, 5> kGaussWeight{0.5688888888888889, 0.4786286704993665,
                                             0.4786286704993665, 0.2369268850561891,
                                             0.2369268850561891};

}  // namespace

Vec2 curve_point(const EdgeCurve& curve, const Vec2& a, const Vec2& b, double t) {
  const double s = 1 - t;
  switch (curve.kind) {
    case EdgeCurve::Kind::line:
      return s * a + t * b;
    case EdgeCurve::Kind::quadratic:
      return s * s * a + 2 * s * t * curve.control[0] + t * t * b;
    case EdgeCurve::Kind::cubic:
      return s * s * s * a + 3 * s * s * t * curve.control[0] + 3 * s * t * t * curve.control[1] +
             t * t * t * b;
    case EdgeCurve::Kind::circle: {
      const Arc arc = arc_of(curve, a, b);
      const double angle = arc.start + t * arc.turn;
      return arc.centre + arc.radius * Vec2(std::cos(angle), std::sin(angle));
    }
  }
  return a;
}

Vec2 curve_derivative(const EdgeCurve& curve, const Vec2& a, const Vec2& b, double t) {
  const double s = 1 - t;
  switch (curve.kind) {
    case EdgeCurve::Kind::line:
      return b - a;
    case EdgeCurve::Kind::quadratic:
      return 2 * s * (curve.control[0] - a) + 2 * t * (b - curve.control[0]);
    case EdgeCurve::Kind::cubic:
      return 3 * s * s * (curve.control[0] - a) +
             6 * s * t * (curve.control[1] - curve.control[0]) + 3 * t * t * (b - curve.control[1]);
    case EdgeCurve::Kind::circle: {
      const Arc arc = arc_of(curve, a, b);
      const double angle = arc.start + t * arc.turn;
      return arc.radius * arc.turn * Vec2(-std::sin(angle), std::cos(angle));
    }
  }
  return b - a;
}

double curve_length(const EdgeCurve& curve, const Vec2& a, const Vec2& b, double t0, double t1,
                    int pieces) {
  if (curve.kind == EdgeCurve::Kind::line) return (b - a).norm() * (t1 - t0);
  if (curve.kind == EdgeCurve::Kind::circle) {
    const Arc arc = arc_of(curve, a, b);
    return arc.radius * std::abs(arc.turn) * (t1 - t0);
  }
  const double half = (t1 - t0) / pieces / 2;
  double sum = 0;
  for (int i = 0; i < pieces; ++i)
    for (std::size_t g = 0; g < kGaussNode.size(); ++g)
      sum += kGaussWeight[g] *
             curve_derivative(curve, a, b, t0 + half * (2 * i + 1 + kGaussNode[g])).norm();
  return sum * half;
}

std::pair<EdgeCurve, EdgeCurve> split_curve(const EdgeCurve& curve, const Vec2& a, const Vec2& b,
                                            double t) {
  EdgeCurve left = curve, right = curve;
  const auto mix = [t](const Vec2& p, const Vec2& q) -> Vec2 { return (1 - t) * p + t * q; };
  if (curve.kind == EdgeCurve::Kind::quadratic) {
    left.control = {mix(a, curve.control[0])};
    right.control = {mix(curve.control[0], b)};
  } else if (curve.kind == EdgeCurve::Kind::cubic) {
    const Vec2 p = mix(a, curve.control[0]), q = mix(curve.control[0], curve.control[1]),
               r = mix(curve.control[1], b);
    left.control = {p, mix(p, q)};
    right.control = {mix(q, r), r};
  } else if (curve.kind == EdgeCurve::Kind::circle) {
    const Arc arc = arc_of(curve, a, b);
    left.radius = right.radius = arc.radius;
    left.large_arc = std::abs(arc.turn) * t > kPi;
    right.large_arc = std::abs(arc.turn) * (1 - t) > kPi;
  }
  return {left, right};
}

EdgeCurve mirrored_curve(EdgeCurve curve) {
  for (Vec2& c : curve.control) c.x() = -c.x();
  curve.sweep = !curve.sweep;
  return curve;
}

EdgeCurve reversed_curve(EdgeCurve curve) {
  std::reverse(curve.control.begin(), curve.control.end());
  curve.sweep = !curve.sweep;
  return curve;
}

}  // namespace loosefit::pattern

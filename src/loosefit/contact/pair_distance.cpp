#include "loosefit/contact/pair_distance.h"

#include <algorithm>
#include <cmath>

#include "loosefit/geometry/closest_point.h"

namespace loosefit {
namespace {

PairDistance from_weights(const std::array<double, 4>& w, const Vec3& x0, const Vec3& x1,
                          const Vec3& x2, const Vec3& x3) {
  PairDistance d;
  d.weight = w;
  const Vec3 gap = w[0] * x0 + w[1] * x1 + w[2] * x2 + w[3] * x3;
  d.distance = gap.norm();
  if (d.distance > 0) d.normal = gap / d.distance;
  return d;
}

}  // namespace

PairDistance point_triangle_distance(const Vec3& x0, const Vec3& x1, const Vec3& x2,
                                     const Vec3& x3) {
  const Vec3 b = closest_barycentric(x0, x1, x2, x3);
  return from_weights({1, -b[0], -b[1], -b[2]}, x0, x1, x2, x3);
}

PairDistance edge_edge_distance(const Vec3& x0, const Vec3& x1, const Vec3& x2, const Vec3& x3) {
  const Vec3 d1 = x1 - x0, d2 = x3 - x2, r = x0 - x2;
  const double a = d1.squaredNorm(), e = d2.squaredNorm(), f = d2.dot(r);
  const double b = d1.dot(d2), c = d1.dot(r);
  double s = 0, t = 0;
  if (a <= 0 && e <= 0) {
    // two points
  } else if (a <= 0) {
    t = std::clamp(f / e, 0.0, 1.0);
  } else if (e <= 0) {
    s = std::clamp(-c / a, 0.0, 1.0);
  } else {
    const double denominator = a * e - b * b;
    if (denominator > 0) s = std::clamp((b * f - c * e) / denominator, 0.0, 1.0);
    t = (b * s + f) / e;
    if (t < 0) {
      t = 0;
      s = std::clamp(-c / a, 0.0, 1.0);
    } else if (t > 1) {
      t = 1;
      s = std::clamp((b - c) / a, 0.0, 1.0);
    }
  }
  return from_weights({1 - s, s, -(1 - t), -t}, x0, x1, x2, x3);
}

double time_of_impact(PairKind kind, const std::array<Vec3, 4>& x0, const std::array<Vec3, 4>& dx0,
                      double upper) {
  constexpr double kKeep = 0.1;      // share of the distance that is kept
  constexpr int kMaxAdvances = 200;  // a conservative stop; the bound stays valid
  std::array<Vec3, 4> x = x0, dx = dx0;
  const Vec3 mean = 0.25 * (dx[0] + dx[1] + dx[2] + dx[3]);
  for (Vec3& d : dx) d -= mean;
  const auto length = [&](int i) { return dx[i].norm(); };
  const double reach = kind == PairKind::point_triangle
                           ? length(0) + std::max({length(1), length(2), length(3)})
                           : std::max(length(0), length(1)) + std::max(length(2), length(3));
  if (reach <= 0) return upper;
  const auto distance = [&] {
    return kind == PairKind::point_triangle
               ? point_triangle_distance(x[0], x[1], x[2], x[3]).distance
               : edge_edge_distance(x[0], x[1], x[2], x[3]).distance;
  };
  double d = distance();
  const double keep = kKeep * d;
  double t = 0;
  for (int i = 0; i < kMaxAdvances; ++i) {
    const double advance = 0.9 * (d - keep) / reach;
    if (t + advance >= upper) return upper;
    if (i > 0 && advance * reach < 1e-3 * keep) return t;
    t += advance;
    for (int k = 0; k < 4; ++k) x[k] = x0[k] + t * dx[k];
    d = distance();
    if (d <= keep) return t;
  }
  return t;
}

}  // namespace loosefit

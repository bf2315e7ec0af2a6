#include "loosefit/contact/pair_distance.h"

#include <algorithm>
#include <cmath>

#include "loosefit/base/check.h"
#include "loosefit/contact/contact_tuning.h"
#include "loosefit/geometry/closest_point.h"

namespace loosefit::contact {
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
  const Vec3 b = geometry::closest_barycentric(x0, x1, x2, x3);
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

PairDistance pair_distance(PairKind kind, const PairPoints& x) {
  return kind == PairKind::point_triangle ? point_triangle_distance(x[0], x[1], x[2], x[3])
                                          : edge_edge_distance(x[0], x[1], x[2], x[3]);
}

PairMatrix distance_hessian(PairKind kind, const PairPoints& x, const PairDistance& d) {
  LOOSEFIT_ASSERT(d.distance > 0);
  // ½ d² is the minimum over the free parameters p of ½ |r|², r = Σ w_k(p) x_k, w linear in p. With
  // c_j = ∂w/∂p_j and t_j = Σ c_jk x_k its Hessian is (envelope theorem, then Schur complement)
  //   w wᵀ ⊗ I − Σ_ij (c_i ⊗ r + w ⊗ t_i) (tᵀt)⁻¹_ij (c_j ⊗ r + w ⊗ t_j)ᵀ.
  using Weights = Eigen::Vector4d;
  const Weights w(d.weight[0], d.weight[1], d.weight[2], d.weight[3]);
  std::array<Weights, 2> c;
  int free = 0;
  if (kind == PairKind::edge_edge) {
    if (w[0] != 0 && w[1] != 0) c[free++] = Weights(-1, 1, 0, 0);
    if (w[2] != 0 && w[3] != 0) c[free++] = Weights(0, 0, 1, -1);
  } else {
    int last = 0;  // corners that bear weight; the first of them gives what the others take
    for (int k = 1; k < 4; ++k) {
      if (w[k] == 0) continue;
      if (last > 0) {
        c[free].setZero();
        c[free][last] = 1;
        c[free++][k] = -1;
      }
      last = last > 0 ? last : k;
    }
  }
  std::array<Vec3, 2> t;
  for (int j = 0; j < free; ++j) {
    t[j].setZero();
    for (int k = 0; k < 4; ++k) t[j] += c[j][k] * x[k];
  }
  Eigen::Matrix2d inverse = Eigen::Matrix2d::Zero();
  if (free == 1) {
    inverse(0, 0) = 1 / t[0].squaredNorm();
  } else if (free == 2) {
    const double aa = t[0].squaredNorm(), bb = t[1].squaredNorm(), ab = t[0].dot(t[1]);
    const double determinant = aa * bb - ab * ab;
    constexpr double kParallel = 1e-12;  // sin² below which the nearest points are not unique
    if (determinant > kParallel * aa * bb)
      inverse << bb / determinant, -ab / determinant, -ab / determinant, aa / determinant;
    else
      inverse(0, 0) = 1 / aa;
  }
  PairMatrix h;
  const Mat3 across = (Mat3::Identity() - d.normal * d.normal.transpose()) / d.distance;
  for (int a = 0; a < 4; ++a)
    for (int b = 0; b < 4; ++b) h.block<3, 3>(3 * a, 3 * b) = w[a] * w[b] * across;
  Eigen::Matrix<double, 12, 2> slide = Eigen::Matrix<double, 12, 2>::Zero();
  for (int j = 0; j < free; ++j)
    for (int k = 0; k < 4; ++k)
      slide.block<3, 1>(3 * k, j) = c[j][k] * d.distance * d.normal + w[k] * t[j];
  h -= slide * (inverse / d.distance) * slide.transpose();
  return h;
}

double separation(PairKind kind, const PairPoints& x) {
  const bool point = kind == PairKind::point_triangle;
  const Vec3 axis = point ? Vec3(x[0] - (x[1] + x[2] + x[3]) / 3) : Vec3(x[0] + x[1] - x[2] - x[3]);
  const double length = axis.norm();
  if (!(length > 0)) return 0;
  const double p0 = axis.dot(x[0]), p1 = axis.dot(x[1]), p2 = axis.dot(x[2]), p3 = axis.dot(x[3]);
  const double gap = point ? p0 - std::max({p1, p2, p3}) : std::min(p0, p1) - std::max(p2, p3);
  return std::max(0.0, gap / length);
}

double motion_bound(PairKind kind, const PairPoints& dx) {
  const auto bound = [&](const Vec3& common) {
    PairPoints v;
    for (int k = 0; k < 4; ++k) v[k] = dx[k] - common;
    const double l0 = v[0].squaredNorm(), l1 = v[1].squaredNorm(), l2 = v[2].squaredNorm(),
                 l3 = v[3].squaredNorm();
    return kind == PairKind::point_triangle
               ? std::sqrt(l0) + std::sqrt(std::max({l1, l2, l3}))
               : std::sqrt(std::max(l0, l1)) + std::sqrt(std::max(l2, l3));
  };
  return std::min(bound(Vec3::Zero()), bound(0.25 * (dx[0] + dx[1] + dx[2] + dx[3])));
}

namespace {

/// Gap of the projections on an axis from the second feature to the first.
double projected_gap(PairKind kind, const PairPoints& x, const Vec3& axis) {
  double a[4];
  for (int k = 0; k < 4; ++k) a[k] = axis.dot(x[k]);
  return kind == PairKind::point_triangle ? a[0] - std::max({a[1], a[2], a[3]})
                                          : std::min(a[0], a[1]) - std::max(a[2], a[3]);
}

}  // namespace

double time_of_impact(PairKind kind, const PairPoints& x0, const PairPoints& dx, double upper) {
  constexpr ImpactTuning kTuning = kContact.impact;
  const double reach = motion_bound(kind, dx);
  if (reach <= 0) return upper;
  // Relative to the first point, so that round-off of its coordinates does not hide a gap of
  // nanometres; and relative to the mean motion, which closes no gap.
  PairPoints from = x0, displacement = dx;
  const Vec3 mean = 0.25 * (dx[0] + dx[1] + dx[2] + dx[3]);
  for (int k = 0; k < 4; ++k) from[k] -= x0[0], displacement[k] -= mean;
  PairPoints x = from;
  PairDistance d = pair_distance(kind, x);
  const double keep = kTuning.kept_distance * d.distance;
  double t = 0;
  for (int i = 0; i < kTuning.max_advances && d.distance > keep; ++i) {
    // Nearest points of convex features: along their normal the projections are as far apart, and
    // near as fast as this speed at most. Where round-off has tilted the normal, any motion counts.
    double room = projected_gap(kind, x, d.normal) - keep;
    double speed = -projected_gap(kind, displacement, d.normal);
    if (!(room > 0)) {
      room = d.distance - keep;
      speed = reach;
    }
    if (!std::isfinite(speed)) return t;
    if (speed * (upper - t) < room) return upper;
    if (i > 0 && room < kTuning.min_gain * keep) return t;
    t += room / speed;
    for (int k = 0; k < 4; ++k) x[k] = from[k] + t * displacement[k];
    d = pair_distance(kind, x);
  }
  return t;
}

}  // namespace loosefit::contact

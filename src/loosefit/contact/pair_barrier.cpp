#include "loosefit/contact/pair_barrier.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <cmath>
#include <limits>

#include "loosefit/base/check.h"
#include "loosefit/contact/contact_tuning.h"

namespace loosefit::contact {
namespace {

/// e(c) = r (2 − r), r = c/threshold, with its derivatives; 1 from the threshold on.
struct Mollifier {
  double value = 1, slope = 0, curvature = 0;
};

double parallel_measure(const PairPoints& x) {
  const Vec3 u = x[1] - x[0], v = x[3] - x[2];
  const double uv = u.dot(v);
  return std::max(0.0, u.squaredNorm() * v.squaredNorm() - uv * uv);  // |u × v|²
}

Mollifier mollify(const BarrierPair& pair, const PairPoints& x) {
  if (pair.kind == PairKind::point_triangle) return {};
  const double c = parallel_measure(x), threshold = pair.parallel_threshold;
  if (c >= threshold) return {};
  const double r = c / threshold;
  return {r * (2 - r), (2 - 2 * r) / threshold, -2 / (threshold * threshold)};
}

/// Gradient of |u × v|² with respect to the four edge ends.
PairPoints parallel_gradient(const PairPoints& x) {
  const Vec3 u = x[1] - x[0], v = x[3] - x[2];
  const double uv = u.dot(v);
  const Vec3 du = 2 * (v.squaredNorm() * u - uv * v), dv = 2 * (u.squaredNorm() * v - uv * u);
  return {-du, du, -dv, dv};
}

PairMatrix parallel_hessian(const PairPoints& x) {
  const Vec3 u = x[1] - x[0], v = x[3] - x[2];
  const Mat3 one = Mat3::Identity();
  const Mat3 uu = 2 * (v.squaredNorm() * one - v * v.transpose());
  const Mat3 vv = 2 * (u.squaredNorm() * one - u * u.transpose());
  const Mat3 uv = 2 * (2 * u * v.transpose() - v * u.transpose() - u.dot(v) * one);
  const auto sign = [](int k) { return k % 2 ? 1.0 : -1.0; };
  PairMatrix h;
  for (int a = 0; a < 4; ++a)
    for (int b = 0; b < 4; ++b) {
      const Mat3 block = a < 2 ? (b < 2 ? uu : uv) : (b < 2 ? Mat3(uv.transpose()) : vv);
      h.block<3, 3>(3 * a, 3 * b) = sign(a) * sign(b) * block;
    }
  return h;
}

using Column = Eigen::Matrix<double, 12, 1>;
Column stacked(const PairPoints& p) {
  Column c;
  c << p[0], p[1], p[2], p[3];
  return c;
}

/// Π/e from Π: e may be 0 where edges are parallel, so from the law itself.
double bare_energy(const BarrierPair& pair, double distance) {
  const double s = distance / pair.reach;
  return -pair.scale * pair.reach * (s - 1) * (s - 1) * std::log(s);
}

}  // namespace

Barrier evaluate_barrier(const BarrierPair& pair, const PairPoints& x) {
  Barrier b;
  b.d = pair_distance(pair.kind, x);
  const double s = b.d.distance / pair.reach;
  if (s >= 1) return b;
  b.active = true;
  if (!(s > 0)) {
    b.energy = std::numeric_limits<double>::infinity();
    return b;
  }
  const double log_s = std::log(s), e = mollify(pair, x).value;
  const double scale = e * pair.scale;
  b.energy = -scale * pair.reach * (s - 1) * (s - 1) * log_s;
  b.slope = scale * (s - 1) * (-2 * log_s - (s - 1) / s);
  b.curvature = scale / pair.reach * (-2 * log_s - 4 * (s - 1) / s + (s - 1) * (s - 1) / (s * s));
  return b;
}

PairPoints barrier_gradient(const BarrierPair& pair, const PairPoints& x, const Barrier& b) {
  LOOSEFIT_ASSERT(b.active && b.d.distance > 0);
  PairPoints g;
  for (int k = 0; k < 4; ++k) g[k] = b.slope * b.d.weight[k] * b.d.normal;
  const Mollifier m = mollify(pair, x);
  if (m.slope > 0 && b.d.distance > 0) {
    const double energy = bare_energy(pair, b.d.distance);
    const PairPoints dc = parallel_gradient(x);
    for (int k = 0; k < 4; ++k) g[k] += energy * m.slope * dc[k];
  }
  return g;
}

namespace {

PairMatrix exact_hessian(const BarrierPair& pair, const PairPoints& x, const Barrier& b,
                         const Column& gap) {
  PairMatrix h = b.curvature * gap * gap.transpose();
  h += b.slope * distance_hessian(pair.kind, x, b.d);
  const Mollifier m = mollify(pair, x);
  if (m.curvature == 0) return h;
  const double s = b.d.distance / pair.reach;
  const double energy = bare_energy(pair, b.d.distance);
  const double slope = pair.scale * (s - 1) * (-2 * std::log(s) - (s - 1) / s);
  const Column c = stacked(parallel_gradient(x));
  h += m.slope * slope * (gap * c.transpose() + c * gap.transpose());
  h += energy * (m.curvature * c * c.transpose() + m.slope * parallel_hessian(x));
  return h;
}

PairMatrix without_negative_part(const PairMatrix& h) {
  const Eigen::SelfAdjointEigenSolver<PairMatrix> modes(h);
  const PairMatrix& v = modes.eigenvectors();
  return v * modes.eigenvalues().cwiseMax(0.0).asDiagonal() * v.transpose();
}

}  // namespace

PairMatrix barrier_hessian(const BarrierPair& pair, const PairPoints& x, const Barrier& b,
                           particles::HessianKind kind) {
  LOOSEFIT_ASSERT(b.active && b.d.distance > 0);
  Column gap;  // ∂d/∂x
  for (int k = 0; k < 4; ++k) gap.segment<3>(3 * k) = b.d.weight[k] * b.d.normal;
  const bool exact = kind == particles::HessianKind::exact;
  const bool pressed = b.d.distance < kContact.barrier.pressed * pair.reach;
  if (!(b.d.distance > 0) || (!exact && !pressed)) return b.curvature * gap * gap.transpose();
  const PairMatrix h = exact_hessian(pair, x, b, gap);
  return exact ? h : without_negative_part(h);
}

}  // namespace loosefit::contact

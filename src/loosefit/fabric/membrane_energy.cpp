#include "loosefit/fabric/membrane_energy.h"

#include <tbb/parallel_for.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "loosefit/base/error.h"

namespace loosefit {

namespace {

StressCurve tension_law(const std::vector<CurvePoint>& curve, double stiffness,
                        double compression) {
  return curve.empty() ? StressCurve::linear(stiffness, compression)
                       : StressCurve::tension(curve, compression);
}

// Nearest positive semi-definite matrix of a tangent whose shear does not couple.
Mat3 without_negative_part(Mat3 c) {
  const double mean = 0.5 * (c(0, 0) + c(1, 1)), half = 0.5 * (c(0, 0) - c(1, 1));
  const double radius = std::hypot(half, c(0, 1));
  if (mean - radius < 0) {
    const double high = std::max(0.0, mean + radius);  // the eigenvalue that stays
    const double share = radius > 0 ? half / radius : 0;
    c(0, 0) = 0.5 * high * (1 + share);
    c(1, 1) = 0.5 * high * (1 - share);
    c(0, 1) = c(1, 0) = radius > 0 ? 0.5 * high * c(0, 1) / radius : 0;
  }
  c(2, 2) = std::max(0.0, c(2, 2));
  return c;
}

}  // namespace

MembraneEnergy::MembraneEnergy(const std::vector<Triangle>& triangles,
                               const std::vector<std::array<Vec2, 3>>& triangle_uv,
                               const std::vector<double>& factor, const Material& material,
                               bool viscous)
    : damping_(viscous ? material.damping : 0) {
  const Material& m = material;
  const double ku = m.stiffness_weft, kv = m.stiffness_warp, nu = m.poisson;
  const double squeeze = m.compression_factor;
  plain_ = m.curve_warp.empty() && m.curve_weft.empty() && m.curve_shear.empty() && squeeze == 1;
  const double plate = 1 - nu * nu * squeeze;
  linear_ = Mat3::Zero();
  linear_(0, 0) = ku / plate;
  linear_(1, 1) = kv / plate;
  linear_(0, 1) = linear_(1, 0) = nu * std::sqrt(ku * kv) / plate;
  linear_(2, 2) = m.stiffness_shear;
  law_u_ = tension_law(m.curve_weft, ku / plate, squeeze);
  law_v_ = tension_law(m.curve_warp, kv / plate, squeeze);
  law_s_ = m.curve_shear.empty() ? StressCurve::linear(m.stiffness_shear)
                                 : StressCurve::shear(m.curve_shear);
  coupling_ = nu * std::sqrt(std::max(0.0, law_u_.smallest_tangent()) *
                             std::max(0.0, law_v_.smallest_tangent()));
  elements_.reserve(triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const auto& [a, b, c] = triangle_uv[i];
    const double d = a[0] * (b[1] - c[1]) + b[0] * (c[1] - a[1]) + c[0] * (a[1] - b[1]);
    if (!(std::abs(d) > 0))
      throw GeometryError("pattern triangle " + std::to_string(i) + " has no area");
    Element e;
    e.t = triangles[i];
    e.ru = {(b[1] - c[1]) / d, (c[1] - a[1]) / d, (a[1] - b[1]) / d};
    e.rv = {(c[0] - b[0]) / d, (a[0] - c[0]) / d, (b[0] - a[0]) / d};
    e.area = 0.5 * std::abs(d);
    e.factor = factor.empty() ? 1.0 : factor[i];
    elements_.push_back(e);
  }
  strain_start_.assign(elements_.size(), Vec3::Zero());
  if (!plain_) tangent_start_.assign(elements_.size(), Mat3::Zero());
}

MembraneEnergy::Kinematics MembraneEnergy::kinematics(const Element& e,
                                                      const VectorField& x) const {
  Kinematics k;
  k.u = e.ru[0] * x[e.t[0]] + e.ru[1] * x[e.t[1]] + e.ru[2] * x[e.t[2]];
  k.v = e.rv[0] * x[e.t[0]] + e.rv[1] * x[e.t[1]] + e.rv[2] * x[e.t[2]];
  k.strain = {0.5 * (k.u.squaredNorm() - 1), 0.5 * (k.v.squaredNorm() - 1), k.u.dot(k.v)};
  return k;
}

double MembraneEnergy::energy(std::size_t i, const Vec3& strain) const {
  const Element& e = elements_[i];
  double sum = plain_ ? 0.5 * e.area * strain.dot(linear(e) * strain)
                      : e.area * e.factor *
                            (law_u_.at(strain[0]).energy + law_v_.at(strain[1]).energy +
                             law_s_.at(strain[2]).energy + coupling_ * strain[0] * strain[1]);
  if (viscous_ratio_ > 0) {
    const Vec3 d = strain - strain_start_[i];
    sum += 0.5 * e.area * viscous_ratio_ * d.dot((e.factor * viscosity(i)) * d);
  }
  return sum;
}

Vec3 MembraneEnergy::elastic_stress(const Element& e, const Vec3& strain) const {
  if (plain_) return linear(e) * strain;
  return e.factor * Vec3(law_u_.at(strain[0]).stress + coupling_ * strain[1],
                         law_v_.at(strain[1]).stress + coupling_ * strain[0],
                         law_s_.at(strain[2]).stress);
}

Vec3 MembraneEnergy::stress(std::size_t i, const Vec3& strain) const {
  const Element& e = elements_[i];
  Vec3 s = elastic_stress(e, strain);
  if (viscous_ratio_ > 0)
    s += viscous_ratio_ * ((e.factor * viscosity(i)) * (strain - strain_start_[i]));
  return s;
}

Mat3 MembraneEnergy::general_tangent(const Vec3& strain) const {
  Mat3 c = Mat3::Zero();
  c(0, 0) = law_u_.at(strain[0]).tangent;
  c(1, 1) = law_v_.at(strain[1]).tangent;
  c(0, 1) = c(1, 0) = coupling_;
  c(2, 2) = law_s_.at(strain[2]).tangent;
  return c;
}

Mat3 MembraneEnergy::tangent(std::size_t i, const Vec3& strain, HessianKind kind) const {
  const Element& e = elements_[i];
  if (plain_) return linear(e) * (1 + viscous_ratio_);
  Mat3 c = general_tangent(strain);
  if (kind == HessianKind::definite) c = without_negative_part(c);
  if (viscous_ratio_ > 0) c += viscous_ratio_ * viscosity(i);
  return e.factor * c;
}

void MembraneEnergy::begin_step(const VectorField& x, double dt) {
  viscous_ratio_ = std::isfinite(dt) && dt > 0 ? damping_ / dt : 0;
  if (!(viscous_ratio_ > 0)) return;
  for (std::size_t i = 0; i < elements_.size(); ++i) {
    strain_start_[i] = kinematics(elements_[i], x).strain;
    if (!plain_) tangent_start_[i] = without_negative_part(general_tangent(strain_start_[i]));
  }
}

double MembraneEnergy::value(const VectorField& x) const {
  std::vector<double> part(elements_.size());
  tbb::parallel_for(std::size_t{0}, elements_.size(), [&](std::size_t i) {
    part[i] = energy(i, kinematics(elements_[i], x).strain);
  });
  double sum = 0;
  for (double p : part) sum += p;
  return sum;
}

void MembraneEnergy::add_gradient(const VectorField& x, VectorField& g) const {
  std::vector<std::array<Vec3, 3>> part(elements_.size());
  tbb::parallel_for(std::size_t{0}, elements_.size(), [&](std::size_t i) {
    const Element& e = elements_[i];
    const Kinematics k = kinematics(e, x);
    const Vec3 s = stress(i, k.strain);
    const Vec3 pu = e.area * (s[0] * k.u + s[2] * k.v), pv = e.area * (s[2] * k.u + s[1] * k.v);
    for (int j = 0; j < 3; ++j) part[i][j] = e.ru[j] * pu + e.rv[j] * pv;
  });
  for (std::size_t i = 0; i < elements_.size(); ++i)
    for (int j = 0; j < 3; ++j) g[elements_[i].t[j]] += part[i][j];
}

void MembraneEnergy::add_pattern(const VectorField&, BlockPattern& pattern) const {
  for (const Element& e : elements_) pattern.add_clique(e.t);
}

void MembraneEnergy::add_hessian(const VectorField& x, BlockMatrix& h, HessianKind kind) const {
  std::vector<std::array<Mat3, 6>> part(elements_.size());
  tbb::parallel_for(std::size_t{0}, elements_.size(), [&](std::size_t i) {
    const Element& e = elements_[i];
    const Kinematics k = kinematics(e, x);
    const Mat3 c = tangent(i, k.strain, kind);
    const Vec3 s = stress(i, k.strain);
    Mat2 stress;
    stress << s[0], s[2], s[2], s[1];
    if (kind == HessianKind::definite) {
      // Keep only the tensile part of the geometric stiffness (Volino et al. 2009).
      const Eigen::SelfAdjointEigenSolver<Mat2> eigen(stress);
      stress = eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(0.0).asDiagonal() *
               eigen.eigenvectors().transpose();
    }
    Eigen::Matrix<double, 3, 3> grad[3];  // columns: derivative of the three strains
    for (int j = 0; j < 3; ++j) {
      grad[j].col(0) = e.ru[j] * k.u;
      grad[j].col(1) = e.rv[j] * k.v;
      grad[j].col(2) = e.ru[j] * k.v + e.rv[j] * k.u;
    }
    int slot = 0;
    for (int a = 0; a < 3; ++a) {
      const Mat3 gc = e.area * grad[a] * c;
      for (int b = 0; b <= a; ++b) {
        const Vec2 ra(e.ru[a], e.rv[a]), rb(e.ru[b], e.rv[b]);
        part[i][slot] = gc * grad[b].transpose();
        part[i][slot].diagonal().array() += e.area * ra.dot(stress * rb);
        ++slot;
      }
    }
  });
  for (std::size_t i = 0; i < elements_.size(); ++i) {
    int slot = 0;
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b <= a; ++b) h.add(elements_[i].t[a], elements_[i].t[b], part[i][slot++]);
  }
}

MembraneEnergy::State MembraneEnergy::state(int triangle, const VectorField& x) const {
  const Element& e = elements_[triangle];
  const Vec3 strain = kinematics(e, x).strain;
  return {strain, elastic_stress(e, strain)};
}

}  // namespace loosefit

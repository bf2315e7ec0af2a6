#include "loosefit/fabric/membrane_energy.h"

#include <tbb/parallel_for.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "loosefit/base/error.h"

namespace loosefit {

MembraneEnergy::MembraneEnergy(const std::vector<Triangle>& triangles,
                               const std::vector<std::array<Vec2, 3>>& triangle_uv,
                               const std::vector<double>& factor, const Material& material,
                               bool viscous)
    : compression_(material.compression_factor), damping_(viscous ? material.damping : 0) {
  const double ku = material.stiffness_weft, kv = material.stiffness_warp, nu = material.poisson;
  const double plate = 1 - nu * nu;
  c_uu_ = ku / plate;
  c_vv_ = kv / plate;
  c_uv_ = nu * std::sqrt(ku * kv) / plate;
  g_ = material.stiffness_shear;
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
}

MembraneEnergy::Kinematics MembraneEnergy::kinematics(const Element& e,
                                                      const VectorField& x) const {
  Kinematics k;
  k.u = e.ru[0] * x[e.t[0]] + e.ru[1] * x[e.t[1]] + e.ru[2] * x[e.t[2]];
  k.v = e.rv[0] * x[e.t[0]] + e.rv[1] * x[e.t[1]] + e.rv[2] * x[e.t[2]];
  k.strain = {0.5 * (k.u.squaredNorm() - 1), 0.5 * (k.v.squaredNorm() - 1), k.u.dot(k.v)};
  return k;
}

Mat3 MembraneEnergy::elastic(const Element& e, const Vec3& strain) const {
  const double cu = strain[0] < 0 ? compression_ : 1, cv = strain[1] < 0 ? compression_ : 1;
  Mat3 c = Mat3::Zero();
  c(0, 0) = cu * c_uu_;
  c(1, 1) = cv * c_vv_;
  c(0, 1) = c(1, 0) = std::sqrt(cu * cv) * c_uv_;
  c(2, 2) = g_;
  return e.factor * c;
}

Mat3 MembraneEnergy::tangent(const Element& e, const Vec3& strain) const {
  return elastic(e, strain) * (1 + viscous_ratio_);
}

void MembraneEnergy::begin_step(const VectorField& x, double dt) {
  viscous_ratio_ = std::isfinite(dt) && dt > 0 ? damping_ / dt : 0;
  if (viscous_ratio_ > 0)
    for (std::size_t i = 0; i < elements_.size(); ++i)
      strain_start_[i] = kinematics(elements_[i], x).strain;
}

double MembraneEnergy::value(const VectorField& x) const {
  std::vector<double> part(elements_.size());
  tbb::parallel_for(std::size_t{0}, elements_.size(), [&](std::size_t i) {
    const Element& e = elements_[i];
    const Vec3 strain = kinematics(e, x).strain;
    const Mat3 c = elastic(e, strain);
    part[i] = 0.5 * e.area * strain.dot(c * strain);
    if (viscous_ratio_ > 0) {
      const Vec3 d = strain - strain_start_[i];
      part[i] += 0.5 * e.area * viscous_ratio_ * d.dot(c * d);
    }
  });
  double energy = 0;
  for (double p : part) energy += p;
  return energy;
}

void MembraneEnergy::add_gradient(const VectorField& x, VectorField& g) const {
  std::vector<std::array<Vec3, 3>> part(elements_.size());
  tbb::parallel_for(std::size_t{0}, elements_.size(), [&](std::size_t i) {
    const Element& e = elements_[i];
    const Kinematics k = kinematics(e, x);
    Vec3 s = elastic(e, k.strain) * k.strain;
    if (viscous_ratio_ > 0)
      s += viscous_ratio_ * (elastic(e, k.strain) * (k.strain - strain_start_[i]));
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
    const Mat3 c = tangent(e, k.strain);
    Vec3 s = elastic(e, k.strain) * k.strain;
    if (viscous_ratio_ > 0)
      s += viscous_ratio_ * (elastic(e, k.strain) * (k.strain - strain_start_[i]));
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
  return {strain, elastic(e, strain) * strain};
}

}  // namespace loosefit

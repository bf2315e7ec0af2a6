#pragma once
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include "loosefit/particles/energy.h"

namespace loosefit::support {

inline Eigen::MatrixXd dense(const particles::BlockMatrix& m) {
  const int n = 3 * m.particles();
  Eigen::MatrixXd d = Eigen::MatrixXd::Zero(n, n);
  for (int j = 0; j < m.particles(); ++j)
    for (int k = m.column_start()[j]; k < m.column_start()[j + 1]; ++k) {
      const int i = m.rows()[k];
      d.block<3, 3>(3 * i, 3 * j) = m.blocks()[k];
      d.block<3, 3>(3 * j, 3 * i) = m.blocks()[k].transpose();
    }
  return d;
}

inline Eigen::MatrixXd dense_hessian(const particles::Energy& energy,
                                     const particles::VectorField& x, particles::HessianKind kind) {
  particles::BlockPattern pattern(static_cast<int>(x.size()));
  energy.add_pattern(x, pattern);
  pattern.compress();
  particles::BlockMatrix h(pattern);
  energy.add_hessian(x, h, kind);
  return dense(h);
}

inline particles::VectorField gradient(const particles::Energy& energy,
                                       const particles::VectorField& x) {
  particles::VectorField g(x.size(), Vec3::Zero());
  energy.add_gradient(x, g);
  return g;
}

/// Gradient = derivative of the energy; exact Hessian = derivative of the gradient; definite
/// Hessian ⪰ 0. Central differences with step h [m]; tolerance relative to the largest entry.
inline void expect_derivatives(const particles::Energy& energy, const particles::VectorField& x,
                               double h = 1e-6, double tolerance = 1e-6,
                               bool check_hessian = true) {
  const particles::VectorField g = gradient(energy, x);
  double g_scale = 1e-12, h_scale = 1e-12;
  for (const Vec3& f : g) g_scale = std::max(g_scale, f.cwiseAbs().maxCoeff());
  Eigen::MatrixXd hessian;
  if (check_hessian) {
    hessian = dense_hessian(energy, x, particles::HessianKind::exact);
    h_scale = std::max(h_scale, hessian.cwiseAbs().maxCoeff());
  }
  for (std::size_t i = 0; i < x.size(); ++i)
    for (int c = 0; c < 3; ++c) {
      particles::VectorField plus = x, minus = x;
      plus[i][c] += h;
      minus[i][c] -= h;
      const double slope = (energy.value(plus) - energy.value(minus)) / (2 * h);
      // Round-off of the energy difference adds to the truncation error.
      const double noise = 1e-15 * std::abs(energy.value(x)) / h * 10;
      EXPECT_NEAR(slope, g[i][c], tolerance * g_scale + noise) << "gradient, particle " << i;
      if (!check_hessian) continue;
      const particles::VectorField gp = gradient(energy, plus), gm = gradient(energy, minus);
      for (std::size_t j = 0; j < x.size(); ++j)
        for (int d = 0; d < 3; ++d)
          EXPECT_NEAR((gp[j][d] - gm[j][d]) / (2 * h), hessian(3 * j + d, 3 * i + c),
                      tolerance * h_scale)
              << "Hessian, particles " << j << ", " << i;
    }
  const Eigen::MatrixXd definite = dense_hessian(energy, x, particles::HessianKind::projected);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(definite, Eigen::EigenvaluesOnly);
  EXPECT_GE(eigen.eigenvalues().minCoeff(),
            -1e-9 * std::max(1e-12, eigen.eigenvalues().maxCoeff()));
}

/// Internal forces neither push nor turn: Σ F = 0 and Σ x × F = 0.
inline void expect_no_net_force_or_torque(const particles::Energy& energy,
                                          const particles::VectorField& x) {
  Vec3 force = Vec3::Zero(), torque = Vec3::Zero();
  double scale = 1e-12;
  const particles::VectorField g = gradient(energy, x);
  for (std::size_t i = 0; i < x.size(); ++i) {
    force += g[i];
    torque += x[i].cross(g[i]);
    scale = std::max(scale, g[i].norm());
  }
  EXPECT_LT(force.norm(), 1e-10 * scale);
  EXPECT_LT(torque.norm(), 1e-10 * scale);
}

/// The energy does not change under rotation and translation.
inline void expect_rigid_invariance(const particles::Energy& energy,
                                    const particles::VectorField& x) {
  const Eigen::AngleAxisd turn(1.1, Vec3(1, -2, 0.5).normalized());
  particles::VectorField moved = x;
  for (Vec3& p : moved) p = turn * p + Vec3(0.3, -0.2, 0.7);
  EXPECT_NEAR(energy.value(moved), energy.value(x), 1e-11 * std::max(1e-6, energy.value(x)));
}

}  // namespace loosefit::support

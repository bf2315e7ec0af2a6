#include "loosefit/fabric/bending_energy.h"

#include <tbb/parallel_for.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <cmath>
#include <map>

namespace loosefit {
namespace {

Mat3 cross_matrix(const Vec3& a) {
  Mat3 m;
  m << 0, -a[2], a[1], a[2], 0, -a[0], -a[1], a[0], 0;
  return m;
}

using Matrix12 = Eigen::Matrix<double, 12, 12>;

/// stiffness ∇θ∇θᵀ + moment ∇²θ without its negative eigenvalues.
Matrix12 definite_part(const Dihedral& d, double stiffness, double moment) {
  Matrix12 h;
  for (int a = 0; a < 4; ++a)
    for (int b = 0; b < 4; ++b)
      h.block<3, 3>(3 * a, 3 * b) =
          stiffness * d.gradient[a] * d.gradient[b].transpose() + moment * d.hessian[a][b];
  const Eigen::SelfAdjointEigenSolver<Matrix12> eigen(h);
  return eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(0.0).asDiagonal() *
         eigen.eigenvectors().transpose();
}

}  // namespace

Dihedral dihedral(const Vec3& x0, const Vec3& x1, const Vec3& x2, const Vec3& x3,
                  bool with_hessian) {
  Dihedral d;
  const Vec3 e = x1 - x0;
  const double length = e.norm();
  const Vec3 unit = e / length;
  const Vec3 n1 = e.cross(x2 - x0), n2 = (x3 - x0).cross(e);
  const double q1 = n1.squaredNorm(), q2 = n2.squaredNorm();
  d.angle = std::atan2(n1.cross(n2).dot(unit), n1.dot(n2));
  const Vec3 m1 = n1 / q1, m2 = n2 / q2;
  const double c10 = (x2 - x1).dot(unit), c20 = (x3 - x1).dot(unit);
  const double c11 = (x2 - x0).dot(unit), c21 = (x3 - x0).dot(unit);
  d.gradient = {-(c10 * m1 + c20 * m2), c11 * m1 + c21 * m2, -length * m1, -length * m2};
  if (!with_hessian) return d;

  const Mat3 r1 = (Mat3::Identity() - 2 * n1 * n1.transpose() / q1) / q1;
  const Mat3 r2 = (Mat3::Identity() - 2 * n2 * n2.transpose() / q2) / q2;
  // Derivatives of m1, m2 with respect to the four points.
  const Mat3 zero = Mat3::Zero();
  const std::array<Mat3, 4> dm1 = {r1 * cross_matrix(x2 - x1), -r1 * cross_matrix(x2 - x0),
                                   r1 * cross_matrix(e), zero};
  const std::array<Mat3, 4> dm2 = {-r2 * cross_matrix(x3 - x1), r2 * cross_matrix(x3 - x0), zero,
                                   -r2 * cross_matrix(e)};
  const std::array<Vec3, 4> dlength = {-unit, unit, Vec3::Zero(), Vec3::Zero()};
  const Mat3 project = (Mat3::Identity() - unit * unit.transpose()) / length;
  // c = (p − q)·unit: derivative through unit is ±project (p − q), through p and q is ±unit.
  const auto derivative = [&](const Vec3& difference, int p, int q) {
    std::array<Vec3, 4> dc = {-project * difference, project * difference, Vec3::Zero(),
                              Vec3::Zero()};
    dc[p] += unit;
    dc[q] -= unit;
    return dc;
  };
  const auto dc10 = derivative(x2 - x1, 2, 1), dc20 = derivative(x3 - x1, 3, 1);
  const auto dc11 = derivative(x2 - x0, 2, 0), dc21 = derivative(x3 - x0, 3, 0);
  for (int j = 0; j < 4; ++j) {
    d.hessian[0][j] =
        -(m1 * dc10[j].transpose() + c10 * dm1[j] + m2 * dc20[j].transpose() + c20 * dm2[j]);
    d.hessian[1][j] =
        m1 * dc11[j].transpose() + c11 * dm1[j] + m2 * dc21[j].transpose() + c21 * dm2[j];
    d.hessian[2][j] = -(m1 * dlength[j].transpose() + length * dm1[j]);
    d.hessian[3][j] = -(m2 * dlength[j].transpose() + length * dm2[j]);
  }
  return d;
}

BendingEnergy::BendingEnergy(const std::vector<Triangle>& triangles,
                             const std::vector<std::array<Vec2, 3>>& triangle_uv,
                             const std::vector<double>& added_rigidity, const Material& material,
                             bool viscous)
    : damping_(viscous ? material.damping : 0) {
  struct Side {
    int triangle, corner;  ///< edge runs from corner to corner + 1
  };
  std::map<std::pair<int, int>, std::vector<Side>> edges;
  for (int i = 0; i < static_cast<int>(triangles.size()); ++i)
    for (int k = 0; k < 3; ++k)
      edges[std::minmax(triangles[i][k], triangles[i][(k + 1) % 3])].push_back({i, k});
  const auto flat_area = [&](int t) {
    const auto& [a, b, c] = triangle_uv[t];
    return 0.5 * std::abs((b - a)[0] * (c - a)[1] - (b - a)[1] * (c - a)[0]);
  };
  // Rigidity for curvature across the edge, as seen in the pattern of one of its triangles.
  const auto rigidity = [&](const Side& s) {
    const Vec2 edge =
        triangle_uv[s.triangle][(s.corner + 1) % 3] - triangle_uv[s.triangle][s.corner];
    const double cos2 = edge[1] * edge[1] / edge.squaredNorm(), sin2 = 1 - cos2;
    const double bu = material.bending_weft, bv = material.bending_warp;
    const double root = std::sqrt(bu) * cos2 + std::sqrt(bv) * sin2;
    return root * root + (added_rigidity.empty() ? 0.0 : added_rigidity[s.triangle]);
  };
  for (const auto& [key, sides] : edges) {
    if (sides.size() != 2) continue;
    const Side &s1 = sides[0], &s2 = sides[1];
    Hinge h;
    h.v = {triangles[s1.triangle][s1.corner], triangles[s1.triangle][(s1.corner + 1) % 3],
           triangles[s1.triangle][(s1.corner + 2) % 3],
           triangles[s2.triangle][(s2.corner + 2) % 3]};
    const auto edge_length = [&](const Side& s) {
      return (triangle_uv[s.triangle][(s.corner + 1) % 3] - triangle_uv[s.triangle][s.corner])
          .norm();
    };
    const double l = 0.5 * (edge_length(s1) + edge_length(s2));
    h.stiffness = 0.5 * (rigidity(s1) + rigidity(s2)) * l * l /
                  (flat_area(s1.triangle) + flat_area(s2.triangle));
    hinges_.push_back(h);
  }
  angle_start_.assign(hinges_.size(), 0.0);
}

void BendingEnergy::begin_step(const VectorField& x, double dt) {
  viscous_ratio_ = std::isfinite(dt) && dt > 0 ? damping_ / dt : 0;
  if (viscous_ratio_ > 0)
    for (std::size_t i = 0; i < hinges_.size(); ++i) {
      const auto& v = hinges_[i].v;
      angle_start_[i] = dihedral(x[v[0]], x[v[1]], x[v[2]], x[v[3]], false).angle;
    }
}

double BendingEnergy::value(const VectorField& x) const {
  std::vector<double> part(hinges_.size());
  tbb::parallel_for(std::size_t{0}, hinges_.size(), [&](std::size_t i) {
    const auto& [v, k] = hinges_[i];
    const double angle = dihedral(x[v[0]], x[v[1]], x[v[2]], x[v[3]], false).angle;
    const double change = angle - angle_start_[i];
    part[i] = 0.5 * k * (angle * angle + viscous_ratio_ * change * change);
  });
  double energy = 0;
  for (double p : part) energy += p;
  return energy;
}

void BendingEnergy::add_gradient(const VectorField& x, VectorField& g) const {
  std::vector<std::array<Vec3, 4>> part(hinges_.size());
  tbb::parallel_for(std::size_t{0}, hinges_.size(), [&](std::size_t i) {
    const auto& [v, k] = hinges_[i];
    const Dihedral d = dihedral(x[v[0]], x[v[1]], x[v[2]], x[v[3]], false);
    const double moment = k * (d.angle + viscous_ratio_ * (d.angle - angle_start_[i]));
    for (int a = 0; a < 4; ++a) part[i][a] = moment * d.gradient[a];
  });
  for (std::size_t i = 0; i < hinges_.size(); ++i)
    for (int a = 0; a < 4; ++a) g[hinges_[i].v[a]] += part[i][a];
}

void BendingEnergy::add_pattern(const VectorField&, BlockPattern& pattern) const {
  for (const Hinge& h : hinges_) pattern.add_clique(h.v);
}

void BendingEnergy::add_hessian(const VectorField& x, BlockMatrix& h, HessianKind kind) const {
  std::vector<std::array<Mat3, 10>> part(hinges_.size());
  const bool exact = kind == HessianKind::exact;
  constexpr double kFlat = 0.25;  // [rad]; below it the first part alone is close enough
  tbb::parallel_for(std::size_t{0}, hinges_.size(), [&](std::size_t i) {
    const auto& [v, k] = hinges_[i];
    Dihedral d = dihedral(x[v[0]], x[v[1]], x[v[2]], x[v[3]], exact);
    const double stiffness = k * (1 + viscous_ratio_);
    const double moment = k * (d.angle + viscous_ratio_ * (d.angle - angle_start_[i]));
    int slot = 0;
    if (!exact && std::abs(d.angle) > kFlat) {
      d = dihedral(x[v[0]], x[v[1]], x[v[2]], x[v[3]], true);
      const Matrix12 h12 = definite_part(d, stiffness, moment);
      for (int a = 0; a < 4; ++a)
        for (int b = 0; b <= a; ++b) part[i][slot++] = h12.block<3, 3>(3 * a, 3 * b);
      return;
    }
    for (int a = 0; a < 4; ++a)
      for (int b = 0; b <= a; ++b) {
        Mat3& block = part[i][slot++];
        block = stiffness * d.gradient[a] * d.gradient[b].transpose();
        if (exact) block += moment * d.hessian[a][b];
      }
  });
  for (std::size_t i = 0; i < hinges_.size(); ++i) {
    const auto& v = hinges_[i].v;
    int slot = 0;
    for (int a = 0; a < 4; ++a)
      for (int b = 0; b <= a; ++b) h.add(v[a], v[b], part[i][slot++]);
  }
}

}  // namespace loosefit

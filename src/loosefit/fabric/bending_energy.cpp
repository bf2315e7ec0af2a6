#include "loosefit/fabric/bending_energy.h"

#include <tbb/parallel_for.h>

#include <Eigen/Eigenvalues>
#include <cmath>

namespace loosefit {
namespace {

using Matrix12 = Eigen::Matrix<double, 12, 12>;

/// stiffness ∇θ∇θᵀ + moment ∇²θ without its negative eigenvalues.
Matrix12 definite_part(const Dihedral& d, const DihedralHessian& second, double stiffness,
                       double moment) {
  Matrix12 h;
  for (int a = 0; a < 4; ++a)
    for (int b = 0; b < 4; ++b)
      h.block<3, 3>(3 * a, 3 * b) =
          stiffness * d.gradient[a] * d.gradient[b].transpose() + moment * second[a][b];
  const Eigen::SelfAdjointEigenSolver<Matrix12> eigen(h);
  return eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(0.0).asDiagonal() *
         eigen.eigenvectors().transpose();
}

/// Smallest stiffness of a patch against any combination of its real angles.
double least_stiffness(const Mat3& stiffness, const std::array<int, 9>& hinge) {
  Mat3 m = stiffness;
  double largest = stiffness.trace();
  for (int k = 0; k < 3; ++k)
    if (hinge[k] < 0) m(k, k) = largest;
  const Eigen::SelfAdjointEigenSolver<Mat3> eigen(m, Eigen::EigenvaluesOnly);
  return std::max(0.0, eigen.eigenvalues()[0]);
}

}  // namespace

Mat3 plate_rigidity(const Material& m, double added) {
  const double root = std::sqrt(m.bending_weft * m.bending_warp), nu = m.bending_poisson;
  Mat3 d = Mat3::Zero();
  d(0, 0) = m.bending_weft + added;
  d(1, 1) = m.bending_warp + added;
  d(0, 1) = d(1, 0) = nu * (root + added);
  d(2, 2) = 0.5 * (1 - nu) * (root + added);
  return d;
}

BendingEnergy::BendingEnergy(const std::vector<Triangle>& triangles,
                             const std::vector<std::array<Vec2, 3>>& triangle_uv,
                             const std::vector<double>& added_rigidity, const Material& material,
                             bool viscous, const std::vector<char>& built_in)
    : friction_({material.bending_hysteresis_weft, material.bending_hysteresis_warp},
                {material.bending_weft, material.bending_warp}),
      damping_(viscous ? material.damping : 0) {
  std::vector<Mat3> rigidity;
  for (std::size_t t = 0; t < triangles.size(); ++t)
    rigidity.push_back(plate_rigidity(material, added_rigidity.empty() ? 0.0 : added_rigidity[t]));
  mesh_ = curvature_patches(triangles, triangle_uv, rigidity, built_in);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const CurvaturePatch& p = mesh_.patches[t];
    stiffness_.push_back(p.area * p.s.transpose() * rigidity[t] * p.s);
    near_.push_back(p.area * p.fit.transpose() * rigidity[t] * p.fit);
    least_.push_back(least_stiffness(near_.back(), p.hinge));
  }
  angle_start_.assign(triangles.size(), Vector9::Zero());
  anchor_.assign(triangles.size(), Vec3::Zero());
}

std::vector<double> BendingEnergy::angles(const VectorField& x) const {
  std::vector<double> angle(mesh_.hinges.size());
  tbb::parallel_for(std::size_t{0}, angle.size(), [&](std::size_t i) {
    const auto& v = mesh_.hinges[i];
    angle[i] = dihedral_angle(x[v[0]], x[v[1]], x[v[2]], x[v[3]]);
  });
  return angle;
}

BendingEnergy::Vector9 BendingEnergy::of_patch(std::size_t t,
                                               const std::vector<double>& angle) const {
  const CurvaturePatch& p = mesh_.patches[t];
  Vector9 mine = Vector9::Zero();
  for (int k = 0; k < p.hinges; ++k)
    if (p.hinge[k] >= 0) mine[k] = angle[p.hinge[k]];
  return mine;
}

Vec3 BendingEnergy::curvature(int triangle, const VectorField& x) const {
  const CurvaturePatch& p = mesh_.patches[triangle];
  Vec3 sum = Vec3::Zero();
  for (int k = 0; k < p.hinges; ++k)
    if (p.hinge[k] >= 0) {
      const auto& v = mesh_.hinges[p.hinge[k]];
      sum += dihedral_angle(x[v[0]], x[v[1]], x[v[2]], x[v[3]]) * p.s.col(k);
    }
  return sum;
}

void BendingEnergy::begin_step(const VectorField& x, double dt) {
  viscous_ratio_ = std::isfinite(dt) && dt > 0 ? damping_ / dt : 0;
  if (viscous_ratio_ <= 0 && !friction_.active()) return;
  const std::vector<double> angle = angles(x);
  for (std::size_t t = 0; t < mesh_.patches.size(); ++t) {
    angle_start_[t] = of_patch(t, angle);
    if (friction_.active())
      anchor_[t] =
          friction_.carried(friction_.slide(mesh_.patches[t].s * angle_start_[t]), anchor_[t]);
  }
}

double BendingEnergy::value(const VectorField& x) const {
  const std::vector<double> angle = angles(x);
  std::vector<double> part(mesh_.patches.size());
  tbb::parallel_for(std::size_t{0}, part.size(), [&](std::size_t t) {
    const Vector9 a = of_patch(t, angle);
    part[t] = 0.5 * a.dot(stiffness_[t] * a);
    if (viscous_ratio_ > 0) {
      const Vector9 change = a - angle_start_[t];
      part[t] += 0.5 * viscous_ratio_ * change.dot(stiffness_[t] * change);
    }
    if (friction_.active()) {
      const CurvaturePatch& p = mesh_.patches[t];
      part[t] += p.area * friction_.respond(p.s * a, anchor_[t]).energy;
    }
  });
  double energy = 0;
  for (double p : part) energy += p;
  return energy;
}

BendingEnergy::Vector9 BendingEnergy::moments(std::size_t t, const Vector9& angle) const {
  Vector9 m = stiffness_[t] * angle;
  if (viscous_ratio_ > 0) m += viscous_ratio_ * (stiffness_[t] * (angle - angle_start_[t]));
  if (friction_.active()) {
    const CurvaturePatch& p = mesh_.patches[t];
    m += p.area * p.s.transpose() * friction_.respond(p.s * angle, anchor_[t]).moment;
  }
  return m;
}

std::vector<double> BendingEnergy::hinge_moments(const std::vector<double>& angle) const {
  std::vector<Vector9> part(mesh_.patches.size());
  tbb::parallel_for(std::size_t{0}, part.size(),
                    [&](std::size_t t) { part[t] = moments(t, of_patch(t, angle)); });
  std::vector<double> moment(mesh_.hinges.size(), 0.0);
  for (std::size_t t = 0; t < part.size(); ++t)
    for (int k = 0; k < mesh_.patches[t].hinges; ++k)
      if (mesh_.patches[t].hinge[k] >= 0) moment[mesh_.patches[t].hinge[k]] += part[t][k];
  return moment;
}

void BendingEnergy::add_gradient(const VectorField& x, VectorField& g) const {
  std::vector<Dihedral> hinge(mesh_.hinges.size());
  std::vector<double> angle(hinge.size());
  tbb::parallel_for(std::size_t{0}, hinge.size(), [&](std::size_t i) {
    const auto& v = mesh_.hinges[i];
    hinge[i] = dihedral(x[v[0]], x[v[1]], x[v[2]], x[v[3]]);
    angle[i] = hinge[i].angle;
  });
  const std::vector<double> moment = hinge_moments(angle);
  for (std::size_t i = 0; i < hinge.size(); ++i)
    for (int a = 0; a < 4; ++a) g[mesh_.hinges[i][a]] += moment[i] * hinge[i].gradient[a];
}

void BendingEnergy::add_pattern(const VectorField&, BlockPattern& pattern) const {
  for (const CurvaturePatch& p : mesh_.patches)
    for (int a = 0; a < (tangent_ == TangentReach::full ? p.count : p.near); ++a)
      for (int b = 0; b < a; ++b) pattern.add(p.particle[a], p.particle[b]);
}

template <int Hinges>
Eigen::Matrix<double, Hinges, Hinges> BendingEnergy::tangent(std::size_t t,
                                                             const Vector9& angle) const {
  const CurvaturePatch& p = mesh_.patches[t];
  Eigen::Matrix<double, Hinges, Hinges> k;
  Eigen::Matrix<double, 3, Hinges> s;
  if constexpr (Hinges == 9) {
    k = (1 + viscous_ratio_) * stiffness_[t];
    s = p.s;
  } else {
    k = (1 + viscous_ratio_) * near_[t];
    s = p.fit;
  }
  if (friction_.active())
    k += p.area * s.transpose() * friction_.respond(p.s * angle, anchor_[t]).tangent * s;
  return k;
}

template <int Hinges, int Points>
void BendingEnergy::add_patches(const std::vector<Dihedral>& hinge,
                                const std::vector<double>& angle, bool exact,
                                BlockMatrix& h) const {
  std::vector<std::array<Mat3, Points*(Points + 1) / 2>> blocks(mesh_.patches.size());
  const auto points = [](const CurvaturePatch& p) { return Hinges == 9 ? p.count : p.near; };
  tbb::parallel_for(std::size_t{0}, mesh_.patches.size(), [&](std::size_t t) {
    const CurvaturePatch& p = mesh_.patches[t];
    Eigen::Matrix<double, Hinges, Hinges> k = tangent<Hinges>(t, of_patch(t, angle));
    if (!exact) k.diagonal().array() -= (1 + viscous_ratio_) * least_[t];
    Eigen::Matrix<double, 3 * Points, Hinges> gradient;
    gradient.setZero();
    for (int c = 0; c < std::min(Hinges, p.hinges); ++c)
      if (p.hinge[c] >= 0)
        for (int a = 0; a < 4; ++a)
          gradient.template block<3, 1>(3 * p.slot[c][a], c) = hinge[p.hinge[c]].gradient[a];
    const Eigen::Matrix<double, 3 * Points, Hinges> weighted = gradient * k;
    int block = 0;
    for (int a = 0; a < points(p); ++a)
      for (int b = 0; b <= a; ++b)
        blocks[t][block++].noalias() = weighted.template block<3, Hinges>(3 * a, 0) *
                                       gradient.template block<3, Hinges>(3 * b, 0).transpose();
  });
  for (std::size_t t = 0; t < mesh_.patches.size(); ++t) {
    const CurvaturePatch& p = mesh_.patches[t];
    int block = 0;
    for (int a = 0; a < points(p); ++a)
      for (int b = 0; b <= a; ++b) h.add(p.particle[a], p.particle[b], blocks[t][block++]);
  }
}

void BendingEnergy::add_hessian(const VectorField& x, BlockMatrix& h, HessianKind kind) const {
  const bool exact = kind == HessianKind::exact;
  constexpr double kFlat = 0.25;  // [rad]; below it the moment part of a hinge may be left out
  std::vector<Dihedral> hinge(mesh_.hinges.size());
  std::vector<double> angle(hinge.size());
  tbb::parallel_for(std::size_t{0}, hinge.size(), [&](std::size_t i) {
    const auto& v = mesh_.hinges[i];
    hinge[i] = dihedral(x[v[0]], x[v[1]], x[v[2]], x[v[3]]);
    angle[i] = hinge[i].angle;
  });

  // What a hinge may count on for itself when its own block is made definite: the part of the
  // patches' stiffness that is a multiple of the identity.
  std::vector<double> share(hinge.size(), 0.0);
  if (!exact)
    for (std::size_t t = 0; t < mesh_.patches.size(); ++t)
      for (int k = 0; k < 3; ++k)
        if (mesh_.patches[t].hinge[k] >= 0)
          share[mesh_.patches[t].hinge[k]] += (1 + viscous_ratio_) * least_[t];

  const std::vector<double> moment = hinge_moments(angle);
  std::vector<std::array<Mat3, 10>> of_hinge(hinge.size());
  tbb::parallel_for(std::size_t{0}, hinge.size(), [&](std::size_t i) {
    const auto& v = mesh_.hinges[i];
    int slot = 0;
    if (!exact && std::abs(angle[i]) <= kFlat) {
      for (int a = 0; a < 4; ++a)
        for (int b = 0; b <= a; ++b)
          of_hinge[i][slot++] = share[i] * hinge[i].gradient[a] * hinge[i].gradient[b].transpose();
      return;
    }
    DihedralHessian second;
    dihedral(x[v[0]], x[v[1]], x[v[2]], x[v[3]], &second);
    if (exact) {
      for (int a = 0; a < 4; ++a)
        for (int b = 0; b <= a; ++b) of_hinge[i][slot++] = moment[i] * second[a][b];
      return;
    }
    const Matrix12 h12 = definite_part(hinge[i], second, share[i], moment[i]);
    for (int a = 0; a < 4; ++a)
      for (int b = 0; b <= a; ++b) of_hinge[i][slot++] = h12.block<3, 3>(3 * a, 3 * b);
  });
  for (std::size_t i = 0; i < hinge.size(); ++i) {
    int slot = 0;
    for (int a = 0; a < 4; ++a)
      for (int b = 0; b <= a; ++b)
        h.add(mesh_.hinges[i][a], mesh_.hinges[i][b], of_hinge[i][slot++]);
  }

  if (exact && tangent_ == TangentReach::full)
    add_patches<9, 12>(hinge, angle, exact, h);
  else
    add_patches<3, 6>(hinge, angle, exact, h);
}

}  // namespace loosefit

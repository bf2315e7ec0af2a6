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

std::vector<Dihedral> dihedrals(const std::vector<std::array<int, 4>>& hinges,
                                const VectorField& x) {
  std::vector<Dihedral> result(hinges.size());
  tbb::parallel_for(std::size_t{0}, result.size(), [&](std::size_t i) {
    const auto& v = hinges[i];
    result[i] = dihedral(x[v[0]], x[v[1]], x[v[2]], x[v[3]]);
  });
  return result;
}

std::vector<double> angles_of(const std::vector<Dihedral>& hinge) {
  std::vector<double> angle;
  angle.reserve(hinge.size());
  for (const Dihedral& d : hinge) angle.push_back(d.angle);
  return angle;
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
  }
  hinge_stiffness_.assign(mesh_.hinges.size(), 0.0);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const CurvaturePatch& p = mesh_.patches[t];
    for (int k = 0; k < 3; ++k)
      if (p.hinge[k] >= 0)
        hinge_stiffness_[p.hinge[k]] += p.area * p.fit.col(k).dot(rigidity[t] * p.fit.col(k));
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
    // The yarns slide from step to step; iterates of one balance leave no trace.
    if (friction_.active() && std::isfinite(dt))
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
  const std::vector<Dihedral> hinge = dihedrals(mesh_.hinges, x);
  const std::vector<double> angle = angles_of(hinge);
  const std::vector<double> moment = hinge_moments(angle);
  for (std::size_t i = 0; i < hinge.size(); ++i)
    for (int a = 0; a < 4; ++a) g[mesh_.hinges[i][a]] += moment[i] * hinge[i].gradient[a];
}

void BendingEnergy::add_pattern(const VectorField&, BlockPattern& pattern) const {
  if (tangent_ == TangentReach::near) {
    for (const auto& h : mesh_.hinges) pattern.add_clique(h);
    return;
  }
  for (const CurvaturePatch& p : mesh_.patches)
    for (int a = 0; a < p.count; ++a)
      for (int b = 0; b < a; ++b) pattern.add(p.particle[a], p.particle[b]);
}

BendingEnergy::Matrix9 BendingEnergy::tangent(std::size_t t, const Vector9& angle) const {
  const CurvaturePatch& p = mesh_.patches[t];
  Matrix9 k = (1 + viscous_ratio_) * stiffness_[t];
  if (friction_.active())
    k += p.area * p.s.transpose() * friction_.respond(p.s * angle, anchor_[t]).tangent * p.s;
  return k;
}

std::vector<double> BendingEnergy::hinge_stiffness(const std::vector<double>& angle) const {
  std::vector<double> stiffness = hinge_stiffness_;
  for (double& k : stiffness) k *= 1 + viscous_ratio_;
  if (friction_.active())
    for (std::size_t t = 0; t < mesh_.patches.size(); ++t) {
      const CurvaturePatch& p = mesh_.patches[t];
      const Mat3 inner = friction_.respond(p.s * of_patch(t, angle), anchor_[t]).tangent;
      for (int k = 0; k < 3; ++k)
        if (p.hinge[k] >= 0)
          stiffness[p.hinge[k]] += p.area * p.fit.col(k).dot(inner * p.fit.col(k));
    }
  return stiffness;
}

void BendingEnergy::add_patches(const std::vector<Dihedral>& hinge,
                                const std::vector<double>& angle, BlockMatrix& h) const {
  std::vector<std::array<Mat3, 78>> blocks(mesh_.patches.size());
  tbb::parallel_for(std::size_t{0}, mesh_.patches.size(), [&](std::size_t t) {
    const CurvaturePatch& p = mesh_.patches[t];
    Eigen::Matrix<double, 36, 9> gradient = Eigen::Matrix<double, 36, 9>::Zero();
    for (int c = 0; c < p.hinges; ++c)
      if (p.hinge[c] >= 0)
        for (int a = 0; a < 4; ++a)
          gradient.block<3, 1>(3 * p.slot[c][a], c) = hinge[p.hinge[c]].gradient[a];
    const Eigen::Matrix<double, 36, 9> weighted = gradient * tangent(t, of_patch(t, angle));
    int block = 0;
    for (int a = 0; a < p.count; ++a)
      for (int b = 0; b <= a; ++b)
        blocks[t][block++].noalias() =
            weighted.block<3, 9>(3 * a, 0) * gradient.block<3, 9>(3 * b, 0).transpose();
  });
  for (std::size_t t = 0; t < mesh_.patches.size(); ++t) {
    const CurvaturePatch& p = mesh_.patches[t];
    int block = 0;
    for (int a = 0; a < p.count; ++a)
      for (int b = 0; b <= a; ++b) h.add(p.particle[a], p.particle[b], blocks[t][block++]);
  }
}

void BendingEnergy::add_hessian(const VectorField& x, BlockMatrix& h, HessianKind kind) const {
  const bool exact = kind == HessianKind::exact;
  constexpr double kFlat = 0.25;  // [rad]; below it the moment part of a hinge may be left out
  const std::vector<Dihedral> hinge = dihedrals(mesh_.hinges, x);
  const std::vector<double> angle = angles_of(hinge);

  // The full tangent has the stiffness of the angles from the patches (definite in itself);
  // otherwise each hinge has its own.
  const bool patches = tangent_ == TangentReach::full;
  std::vector<double> stiffness(hinge.size(), 0.0);
  if (!patches) stiffness = hinge_stiffness(angle);

  const std::vector<double> moment = hinge_moments(angle);
  std::vector<std::array<Mat3, 10>> of_hinge(hinge.size());
  tbb::parallel_for(std::size_t{0}, hinge.size(), [&](std::size_t i) {
    const auto& v = mesh_.hinges[i];
    int slot = 0;
    if (!exact && std::abs(angle[i]) <= kFlat) {
      for (int a = 0; a < 4; ++a)
        for (int b = 0; b <= a; ++b)
          of_hinge[i][slot++] =
              stiffness[i] * hinge[i].gradient[a] * hinge[i].gradient[b].transpose();
      return;
    }
    DihedralHessian second;
    dihedral(x[v[0]], x[v[1]], x[v[2]], x[v[3]], &second);
    if (exact) {
      for (int a = 0; a < 4; ++a)
        for (int b = 0; b <= a; ++b)
          of_hinge[i][slot++] =
              stiffness[i] * hinge[i].gradient[a] * hinge[i].gradient[b].transpose() +
              moment[i] * second[a][b];
      return;
    }
    const Matrix12 h12 = definite_part(hinge[i], second, stiffness[i], moment[i]);
    for (int a = 0; a < 4; ++a)
      for (int b = 0; b <= a; ++b) of_hinge[i][slot++] = h12.block<3, 3>(3 * a, 3 * b);
  });
  for (std::size_t i = 0; i < hinge.size(); ++i) {
    int slot = 0;
    for (int a = 0; a < 4; ++a)
      for (int b = 0; b <= a; ++b)
        h.add(mesh_.hinges[i][a], mesh_.hinges[i][b], of_hinge[i][slot++]);
  }

  if (patches) add_patches(hinge, angle, h);
}

}  // namespace loosefit

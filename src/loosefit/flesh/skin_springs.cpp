#include "loosefit/flesh/skin_springs.h"

#include "loosefit/geometry/mesh_topology.h"

namespace loosefit {

SkinSprings::SkinSprings(const std::vector<Triangle>& triangles, std::vector<double> stiffness,
                         double tension)
    : edges_(MeshTopology(triangles).edges()),
      stiffness_(std::move(stiffness)),
      tension_(tension) {}

double SkinSprings::value(const VectorField& x) const {
  double energy = 0;
  for (std::size_t i = 0; i < x.size(); ++i)
    energy += 0.5 * stiffness_[i] * (x[i] - target_[i]).squaredNorm();
  for (const auto& [i, j] : edges_)
    energy += 0.5 * tension_ * ((x[i] - target_[i]) - (x[j] - target_[j])).squaredNorm();
  return energy;
}

void SkinSprings::add_gradient(const VectorField& x, VectorField& g) const {
  for (std::size_t i = 0; i < x.size(); ++i) g[i] += stiffness_[i] * (x[i] - target_[i]);
  for (const auto& [i, j] : edges_) {
    const Vec3 force = tension_ * ((x[i] - target_[i]) - (x[j] - target_[j]));
    g[i] += force;
    g[j] -= force;
  }
}

void SkinSprings::add_pattern(const VectorField& x, BlockPattern& pattern) const {
  for (int i = 0; i < static_cast<int>(x.size()); ++i) pattern.add(i, i);
  for (const auto& [i, j] : edges_) pattern.add(j, i);
}

void SkinSprings::add_hessian(const VectorField& x, BlockMatrix& h, HessianKind) const {
  const Mat3 unit = Mat3::Identity();
  for (int i = 0; i < static_cast<int>(x.size()); ++i) h.add(i, i, stiffness_[i] * unit);
  for (const auto& [i, j] : edges_) {
    h.add(i, i, tension_ * unit);
    h.add(j, j, tension_ * unit);
    h.add(j, i, -tension_ * unit);
  }
}

}  // namespace loosefit

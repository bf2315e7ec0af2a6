#include "loosefit/flesh/skin_springs.h"

#include "loosefit/geometry/mesh_topology.h"

namespace loosefit::flesh {

SkinSprings::SkinSprings(const std::vector<Triangle>& triangles, std::vector<double> stiffness,
                         double tension)
    : edges_(geometry::MeshTopology(triangles).edges()),
      stiffness_(std::move(stiffness)),
      tension_(tension) {}

double SkinSprings::value(const particles::VectorField& x) const {
  double energy = 0;
  for (std::size_t i = 0; i < x.size(); ++i)
    energy += 0.5 * stiffness_[i] * (x[i] - target_[i]).squaredNorm();
  for (const auto& [i, j] : edges_)
    energy += 0.5 * tension_ * ((x[i] - target_[i]) - (x[j] - target_[j])).squaredNorm();
  return energy;
}

void SkinSprings::add_gradient(const particles::VectorField& x, particles::VectorField& g) const {
  for (std::size_t i = 0; i < x.size(); ++i) g[i] += stiffness_[i] * (x[i] - target_[i]);
  for (const auto& [i, j] : edges_) {
    const Vec3 force = tension_ * ((x[i] - target_[i]) - (x[j] - target_[j]));
    g[i] += force;
    g[j] -= force;
  }
}

void SkinSprings::add_pattern(const particles::VectorField& x,
                              particles::BlockPattern& pattern) const {
  for (int i = 0; i < static_cast<int>(x.size()); ++i) pattern.add(i, i);
  for (const auto& [i, j] : edges_) pattern.add(j, i);
}

void SkinSprings::add_hessian(const particles::VectorField& x, particles::BlockMatrix& h,
                              particles::HessianKind) const {
  const Mat3 unit = Mat3::Identity();
  for (int i = 0; i < static_cast<int>(x.size()); ++i) h.add(i, i, stiffness_[i] * unit);
  for (const auto& [i, j] : edges_) {
    h.add(i, i, tension_ * unit);
    h.add(j, j, tension_ * unit);
    h.add(j, i, -tension_ * unit);
  }
}

}  // namespace loosefit::flesh

#pragma once
#include <array>
#include <vector>

#include "loosefit/particles/energy.h"

namespace loosefit::flesh {

/// Flesh under skin, as far as it gives way: an elastic foundation (Winkler 1867;
/// docs/theory/body_model.md 7) that pulls every vertex to its target, and a tension that keeps
/// neighbours together,
///
///   Π = Σ ½ k_i |d_i|² + Σ ½ t |d_i − d_j|²,   d = x − target                              [J]
///
/// with the second sum over the edges of the triangles. Displacements die out over some √(t/k)
/// edges.
class SkinSprings : public particles::Energy {
 public:
  /// stiffness: k of each vertex [N/m]; tension: t [N/m].
  SkinSprings(const std::vector<Triangle>& triangles, std::vector<double> stiffness,
              double tension);
  void set_target(particles::VectorField target) { target_ = std::move(target); }
  const particles::VectorField& target() const { return target_; }

  double value(const particles::VectorField& x) const override;
  void add_gradient(const particles::VectorField& x, particles::VectorField& g) const override;
  void add_pattern(const particles::VectorField& x,
                   particles::BlockPattern& pattern) const override;
  void add_hessian(const particles::VectorField& x, particles::BlockMatrix& h,
                   particles::HessianKind kind) const override;

 private:
  std::vector<std::array<int, 2>> edges_;
  std::vector<double> stiffness_;
  double tension_;
  particles::VectorField target_;
};

}  // namespace loosefit::flesh

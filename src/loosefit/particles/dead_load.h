#pragma once
#include <vector>

#include "loosefit/particles/energy.h"

namespace loosefit::particles {

/// Forces that do not depend on where the particles are: Π = −Σ f_i · x_i, f_i [N]. Without forces
/// it is nothing.
class DeadLoad : public Energy {
 public:
  /// One per particle, or none at all.
  void set_forces(VectorField forces) { forces_ = std::move(forces); }
  const VectorField& forces() const { return forces_; }
  double value(const VectorField& x) const override;
  void add_gradient(const VectorField& x, VectorField& g) const override;
  void add_pattern(const VectorField&, BlockPattern&) const override {}
  void add_hessian(const VectorField&, BlockMatrix&, HessianKind) const override {}

 private:
  VectorField forces_;
};

}  // namespace loosefit::particles

#pragma once
#include <vector>

#include "loosefit/particles/energy.h"

namespace loosefit::particles {

/// Dead weight: Π = Σ m_i g z_i, force (0, 0, −m_i g).  m_i [kg], g [m/s²], z up.
class GravityEnergy : public Energy {
 public:
  GravityEnergy(std::vector<double> masses, double gravity)
      : masses_(std::move(masses)), gravity_(gravity) {}
  void set_gravity(double gravity) { gravity_ = gravity; }
  double value(const VectorField& x) const override;
  void add_gradient(const VectorField& x, VectorField& g) const override;
  void add_pattern(const VectorField&, BlockPattern&) const override {}
  void add_hessian(const VectorField&, BlockMatrix&, HessianKind) const override {}

 private:
  std::vector<double> masses_;
  double gravity_;
};

}  // namespace loosefit::particles

#include "loosefit/particles/gravity_energy.h"

namespace loosefit {

double GravityEnergy::value(const VectorField& x) const {
  double energy = 0;
  for (std::size_t i = 0; i < x.size(); ++i) energy += masses_[i] * gravity_ * x[i][2];
  return energy;
}

void GravityEnergy::add_gradient(const VectorField& x, VectorField& g) const {
  for (std::size_t i = 0; i < x.size(); ++i) g[i][2] += masses_[i] * gravity_;
}

}  // namespace loosefit

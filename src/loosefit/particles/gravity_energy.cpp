#include "loosefit/particles/gravity_energy.h"

#include <array>

namespace loosefit::particles {

double GravityEnergy::value(const VectorField& x) const {
  constexpr std::size_t kChains = 4;  // independent sums, always the same ones
  std::array<double, kChains> energy{};
  std::size_t i = 0;
  for (; i + kChains <= x.size(); i += kChains)
    for (std::size_t c = 0; c < kChains; ++c) energy[c] += masses_[i + c] * x[i + c][2];
  for (; i < x.size(); ++i) energy[0] += masses_[i] * x[i][2];
  return gravity_ * ((energy[0] + energy[1]) + (energy[2] + energy[3]));
}

void GravityEnergy::add_gradient(const VectorField& x, VectorField& g) const {
  for (std::size_t i = 0; i < x.size(); ++i) g[i][2] += masses_[i] * gravity_;
}

}  // namespace loosefit::particles

#include "loosefit/solver/inertia_term.h"

#include <cmath>

namespace loosefit::solver {

InertiaTerm::InertiaTerm(const ParticleSystem& system, const particles::VectorField& target,
                         double dt)
    : system_(system), target_(target), per_dt2_(std::isfinite(dt) ? 1 / (dt * dt) : 0) {}

double InertiaTerm::energy(const particles::VectorField& x) const {
  double sum = 0;
  if (per_dt2_ > 0)
    for (std::size_t i = 0; i < x.size(); ++i)
      if (!system_.is_held(static_cast<int>(i)))
        sum += 0.5 * system_.mass[i] * per_dt2_ * (x[i] - target_[i]).squaredNorm();
  return sum;
}

void InertiaTerm::add_gradient(const particles::VectorField& x, particles::VectorField& g) const {
  if (per_dt2_ > 0)
    for (std::size_t i = 0; i < x.size(); ++i) g[i] += gradient(static_cast<int>(i), x);
  if (per_dt2_ > 0) system_.gather_forces(g);
}

}  // namespace loosefit::solver

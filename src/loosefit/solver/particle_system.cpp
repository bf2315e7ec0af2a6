#include "loosefit/solver/particle_system.h"

#include <cmath>
#include <limits>

namespace loosefit {

void ParticleSystem::set_tangent(BendingTangent tangent) const {
  for (Energy* e : energies)
    if (auto* choice = dynamic_cast<TangentChoice*>(e)) choice->set_tangent(tangent);
}

void ParticleSystem::set_active_set(const ActiveSet* active_set) const {
  for (Energy* e : energies)
    if (auto* user = dynamic_cast<ActiveSetUser*>(e)) user->set_active_set(active_set);
}

void ParticleSystem::begin_step(const VectorField& x, double dt) const {
  for (Energy* e : energies)
    if (auto* lagged = dynamic_cast<LaggedState*>(e)) lagged->begin_step(x, dt);
}

double ParticleSystem::max_step(const VectorField& x, const VectorField& dx) const {
  double share = 1;
  for (Energy* e : energies)
    if (auto* limit = dynamic_cast<StepLimit*>(e)) share = std::min(share, limit->max_step(x, dx));
  return share;
}

double ParticleSystem::potential(const VectorField& x) const {
  double sum = 0;
  for (const Energy* e : energies) sum += e->value(x);
  return sum;
}

VectorField ParticleSystem::gradient(const VectorField& x) const {
  VectorField g(x.size(), Vec3::Zero());
  for (const Energy* e : energies) e->add_gradient(x, g);
  if (!held.empty())
    for (std::size_t i = 0; i < x.size(); ++i)
      if (held[i]) g[i].setZero();
  return g;
}

double ParticleSystem::potential_and_gradient(const VectorField& x, VectorField& g) const {
  g.assign(x.size(), Vec3::Zero());
  double sum = 0;
  for (const Energy* e : energies) sum += e->value_and_gradient(x, g);
  if (!held.empty())
    for (std::size_t i = 0; i < x.size(); ++i)
      if (held[i]) g[i].setZero();
  return sum;
}

double ParticleSystem::lagged_friction_force() const {
  double sum = 0;
  for (const Energy* e : energies)
    if (const auto* lagged = dynamic_cast<const LaggedState*>(e))
      sum += std::pow(lagged->lagged_friction_force(), 2);
  return std::sqrt(sum);
}

std::uint64_t ParticleSystem::pattern_version(const VectorField& x) const {
  std::uint64_t sum = 0;  // versions only grow
  for (const Energy* e : energies) sum += e->pattern_version(x);
  return sum;
}

Residual residual_of(const ParticleSystem& system, const VectorField& gradient) {
  Residual r;
  double force2 = 0, weight2 = 0, weight = 0, largest2 = -1;
  int free = 0;
  for (int i = 0; i < system.particles(); ++i) {
    if (system.is_held(i)) continue;
    const double f2 = gradient[i].squaredNorm(), w = system.mass[i] * system.gravity;
    force2 += f2;
    weight2 += w * w;
    weight += w;
    ++free;
    if (f2 > largest2) {
      largest2 = f2;
      r.worst_particle = i;
    }
  }
  if (free == 0) return r;
  force2 += std::pow(system.lagged_friction_force(), 2);
  if (!(weight2 > 0)) {  // weightless system: report the plain norm
    r.norm = std::sqrt(force2);
    r.largest = std::sqrt(largest2);
    return r;
  }
  r.norm = std::sqrt(force2 / weight2);
  r.largest = std::sqrt(largest2) / (weight / free);
  return r;
}

}  // namespace loosefit

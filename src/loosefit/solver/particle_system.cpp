#include "loosefit/solver/particle_system.h"

#include <cmath>
#include <limits>

namespace loosefit::solver {

void ParticleSystem::set_tangent(particles::BendingTangent tangent) const {
  for (particles::Energy* e : energies)
    if (auto* choice = dynamic_cast<particles::TangentChoice*>(e)) choice->set_tangent(tangent);
}

void ParticleSystem::set_active_set(const particles::ActiveSet* active_set) const {
  for (particles::Energy* e : energies)
    if (auto* user = dynamic_cast<particles::ActiveSetUser*>(e)) user->set_active_set(active_set);
}

void ParticleSystem::begin_step(const particles::VectorField& x, double dt) const {
  for (particles::Energy* e : energies)
    if (auto* lagged = dynamic_cast<particles::LaggedState*>(e)) lagged->begin_step(x, dt);
}

double ParticleSystem::max_step(const particles::VectorField& x,
                                const particles::VectorField& dx) const {
  double share = 1;
  for (particles::Energy* e : energies)
    if (auto* limit = dynamic_cast<particles::StepLimit*>(e))
      share = std::min(share, limit->max_step(x, dx));
  return share;
}

double ParticleSystem::potential(const particles::VectorField& x) const {
  double sum = 0;
  for (const particles::Energy* e : energies) sum += e->value(x);
  return sum;
}

particles::VectorField ParticleSystem::gradient(const particles::VectorField& x) const {
  particles::VectorField g(x.size(), Vec3::Zero());
  for (const particles::Energy* e : energies) e->add_gradient(x, g);
  if (!held.empty())
    for (std::size_t i = 0; i < x.size(); ++i)
      if (held[i]) g[i].setZero();
  return g;
}

double ParticleSystem::potential_and_gradient(const particles::VectorField& x,
                                              particles::VectorField& g) const {
  g.assign(x.size(), Vec3::Zero());
  double sum = 0;
  for (const particles::Energy* e : energies) sum += e->value_and_gradient(x, g);
  if (!held.empty())
    for (std::size_t i = 0; i < x.size(); ++i)
      if (held[i]) g[i].setZero();
  return sum;
}

double ParticleSystem::lagged_friction_force() const {
  double sum = 0;
  for (const particles::Energy* e : energies)
    if (const auto* lagged = dynamic_cast<const particles::LaggedState*>(e))
      sum += std::pow(lagged->lagged_friction_force(), 2);
  return std::sqrt(sum);
}

std::uint64_t ParticleSystem::pattern_version(const particles::VectorField& x) const {
  std::uint64_t sum = 0;  // versions only grow
  for (const particles::Energy* e : energies) sum += e->pattern_version(x);
  return sum;
}

Residual residual_of(const ParticleSystem& system, const particles::VectorField& gradient) {
  Residual r;
  const std::vector<double>& cloth = system.cloth_mass.empty() ? system.mass : system.cloth_mass;
  double force2 = 0, weight2 = 0, weight = 0, largest2 = -1;
  int free = 0;
  for (int i = 0; i < system.particles(); ++i) {
    if (system.is_held(i)) continue;
    const double f2 = gradient[i].squaredNorm(), w = cloth[i] * system.gravity;
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

}  // namespace loosefit::solver

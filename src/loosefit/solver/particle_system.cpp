#include "loosefit/solver/particle_system.h"

#include <cmath>
#include <limits>

namespace loosefit {

void ParticleSystem::set_tangent(TangentReach reach) const {
  for (Energy* e : energies) e->set_tangent(reach);
}

void ParticleSystem::set_focus(const Focus* focus) const {
  for (Energy* e : energies) e->set_focus(focus);
}

void ParticleSystem::begin_step(const VectorField& x, double dt) const {
  for (Energy* e : energies) e->begin_step(x, dt);
}

double ParticleSystem::begin_search(const VectorField& x, const VectorField& dx) const {
  double share = 1;
  for (Energy* e : energies) share = std::min(share, e->begin_search(x, dx));
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

double ParticleSystem::lag() const {
  double sum = 0;
  for (const Energy* e : energies) sum += std::pow(e->lag(), 2);
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
  force2 += std::pow(system.lag(), 2);
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

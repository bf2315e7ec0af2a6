#include "loosefit/solver/particle_system.h"

#include <algorithm>
#include <cmath>

namespace loosefit::solver {

namespace {

constexpr double kFlat = 1e-8;  ///< [m] of a vertex off its plate that is left alone

}  // namespace

std::vector<char> ParticleSystem::no_unknown() const {
  if (plates.empty()) return held;
  std::vector<char> none = held;
  none.resize(mass.size(), 0);
  for (const Plate& plate : plates)
    for (int i : plate.followers) none[i] = 1;
  return none;
}

std::vector<char> ParticleSystem::on_plate() const {
  std::vector<char> on(plates.empty() ? 0 : mass.size(), 0);
  for (const Plate& plate : plates) {
    for (int i : plate.leaders) on[i] = 1;
    for (int i : plate.followers) on[i] = 1;
  }
  return on;
}

std::vector<double> ParticleSystem::carried_mass() const {
  std::vector<double> carried = mass;
  for (const Plate& plate : plates)
    for (std::size_t f = 0; f < plate.followers.size(); ++f) {
      const Vec3 share = plate.weights[f].cwiseAbs();
      for (int k = 0; k < 3; ++k)
        carried[plate.leaders[k]] += mass[plate.followers[f]] * share[k] * share.sum();
    }
  return carried;
}

void ParticleSystem::gather_forces(particles::VectorField& force) const {
  for (const Plate& plate : plates)
    for (std::size_t f = 0; f < plate.followers.size(); ++f) {
      Vec3& own = force[plate.followers[f]];
      for (int k = 0; k < 3; ++k)
        if (!is_held(plate.leaders[k])) force[plate.leaders[k]] += plate.weights[f][k] * own;
      own.setZero();
    }
}

void ParticleSystem::move_followers(particles::VectorField& dx) const {
  for (const Plate& plate : plates)
    for (std::size_t f = 0; f < plate.followers.size(); ++f) {
      Vec3 sum = Vec3::Zero();
      for (int k = 0; k < 3; ++k) sum += plate.weights[f][k] * dx[plate.leaders[k]];
      dx[plate.followers[f]] = sum;
    }
}

bool ParticleSystem::flatten_plates(particles::VectorField& x) const {
  particles::VectorField dx;
  double farthest = 0;
  for (const Plate& plate : plates) {
    double off = 0;
    for (std::size_t f = 0; f < plate.followers.size(); ++f) {
      Vec3 there = Vec3::Zero();
      for (int k = 0; k < 3; ++k) there += plate.weights[f][k] * x[plate.leaders[k]];
      off = std::max(off, (there - x[plate.followers[f]]).norm());
    }
    farthest = std::max(farthest, off);
    if (off <= kFlat) continue;
    if (dx.empty()) dx.assign(x.size(), Vec3::Zero());
    // Least squares over all its particles; held leaders stay, and then so does the plate.
    Mat3 normal = Mat3::Identity(), right;
    for (int k = 0; k < 3; ++k) right.row(k) = x[plate.leaders[k]];
    const bool is_free =
        std::none_of(plate.leaders.begin(), plate.leaders.end(), [&](int i) { return is_held(i); });
    if (is_free)
      for (std::size_t f = 0; f < plate.followers.size(); ++f) {
        normal += plate.weights[f] * plate.weights[f].transpose();
        right += plate.weights[f] * x[plate.followers[f]].transpose();
      }
    const Mat3 leaders = normal.inverse() * right;
    for (int k = 0; k < 3; ++k)
      dx[plate.leaders[k]] = leaders.row(k).transpose() - x[plate.leaders[k]];
    for (std::size_t f = 0; f < plate.followers.size(); ++f)
      dx[plate.followers[f]] = leaders.transpose() * plate.weights[f] - x[plate.followers[f]];
  }
  if (farthest <= kFlat) return false;
  const double share = max_step(x, dx);
  for (std::size_t i = 0; i < x.size(); ++i) x[i] += share * dx[i];
  return true;
}

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
  gather_forces(g);
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
  gather_forces(g);
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

#pragma once
#include <gtest/gtest.h>

#include <cmath>

#include "loosefit/particles/energy_capabilities.h"

namespace loosefit::support {

/// Some of n particles, in two groups that do not touch.
inline particles::ActiveSet two_groups(int n) {
  particles::ActiveSet active_set;
  active_set.inside.assign(n, 0);
  for (int i = 0; i < n; ++i)
    if ((i > n / 8 && i < n / 4) || (i > n / 2 && i < n / 2 + n / 10)) {
      active_set.particles.push_back(i);
      active_set.inside[i] = 1;
    }
  return active_set;
}

/// What an energy says of a place.
struct Answer {
  double value = 0;
  particles::VectorField gradient;
  particles::BlockMatrix hessian;
};
inline Answer ask(const particles::Energy& energy, const particles::VectorField& x,
                  particles::HessianKind kind) {
  Answer a;
  a.gradient.assign(x.size(), Vec3::Zero());
  a.value = energy.value_and_gradient(x, a.gradient);
  EXPECT_NEAR(energy.value(x), a.value, 1e-12 * std::abs(a.value));
  particles::BlockPattern pattern(static_cast<int>(x.size()));
  energy.add_pattern(x, pattern);
  pattern.compress();
  a.hessian = particles::BlockMatrix(pattern);
  energy.add_hessian(x, a.hessian, kind);
  return a;
}

/// How far the particles may go along dx.
inline double allowed_share(particles::Energy& energy, const particles::VectorField& x,
                            const particles::VectorField& dx) {
  auto* limit = dynamic_cast<particles::StepLimit*>(&energy);
  return limit ? limit->max_step(x, dx) : 1;
}

/// Forces on the particles of the active set and the blocks among them have the same bits as
/// without it, the energy changes as much from x to where the active set moves by up to `move` [m];
/// and when the active set has ended all is as before. Returns the norm of those forces.
template <class AnEnergy>
double expect_same_in_active_set(AnEnergy& energy, const particles::VectorField& x,
                                 const particles::ActiveSet& active_set, double move,
                                 particles::HessianKind kind) {
  particles::VectorField y = x, dx(x.size(), Vec3::Zero());
  for (int i : active_set.particles) {
    dx[i] = move * Vec3(std::sin(3 * i), std::cos(5 * i), std::sin(7 * i));
    y[i] += dx[i];
  }
  const double whole_share = allowed_share(energy, x, dx);
  const Answer before = ask(energy, x, kind), whole = ask(energy, y, kind);
  // Whatever was kept of another place must not be taken for this one.
  const auto displaced = [&](const particles::VectorField& from, bool all) {
    particles::VectorField z = from;
    for (std::size_t i = 0; i < z.size(); ++i)
      if (all || active_set.inside[i])
        z[i] += 0.1 * move * Vec3(std::cos(2.0 * i), std::sin(3.0 * i), 0.3);
    return z;
  };
  ask(energy, displaced(x, true), particles::HessianKind::exact);
  energy.set_active_set(&active_set);
  EXPECT_EQ(allowed_share(energy, x, dx), whole_share);
  const Answer start = ask(energy, x, kind), part = ask(energy, y, kind);
  EXPECT_NEAR(part.value - start.value, whole.value - before.value,
              1e-11 * (std::abs(whole.value) + std::abs(before.value)));
  double force = 0;
  for (int i : active_set.particles) {
    EXPECT_EQ(part.gradient[i], whole.gradient[i]) << "particle " << i;
    force += whole.gradient[i].squaredNorm();
    const auto &first = whole.hessian.column_start(), &rows = whole.hessian.rows();
    for (int k = first[i]; k < first[i + 1]; ++k)
      if (active_set.inside[rows[k]]) {
        EXPECT_EQ(part.hessian.blocks()[part.hessian.slot(rows[k], i)], whole.hessian.blocks()[k])
            << "block " << rows[k] << ", " << i;
      }
  }
  ask(energy, displaced(y, false), particles::HessianKind::exact);
  energy.set_active_set(nullptr);
  const Answer after = ask(energy, y, kind);
  EXPECT_EQ(after.value, whole.value);
  EXPECT_EQ(after.gradient, whole.gradient);
  for (int j = 0; j < whole.hessian.particles(); ++j)
    for (int k = whole.hessian.column_start()[j]; k < whole.hessian.column_start()[j + 1]; ++k)
      EXPECT_EQ(after.hessian.blocks()[after.hessian.slot(whole.hessian.rows()[k], j)],
                whole.hessian.blocks()[k]);
  return std::sqrt(force);
}

}  // namespace loosefit::support

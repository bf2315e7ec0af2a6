#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "loosefit/solver/settle_outcome.h"

namespace loosefit::solver {
namespace {

/// Four particles of 1 g cloth each; the last bears a board of 60 g.
ParticleSystem cloth_with_board() {
  ParticleSystem system;
  system.mass = {1e-3, 1e-3, 1e-3, 61e-3};
  system.cloth_mass = {1e-3, 1e-3, 1e-3, 1e-3};
  system.gravity = 10;
  return system;
}

TEST(Residual, ABoardDoesNotExcuseForcesOnTheCloth) {
  ParticleSystem system = cloth_with_board();
  const particles::VectorField force = {Vec3(0, 0, 2e-3), Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
  // ‖F‖ = 2 mN; ‖W‖ of four times 10 mN is 20 mN, their mean 10 mN.
  const Residual bare = residual_of(system, force);
  EXPECT_NEAR(bare.norm, 0.1, 1e-12);
  EXPECT_NEAR(bare.largest, 0.2, 1e-12);
  EXPECT_EQ(bare.worst_particle, 0);
  // With the board in the denominator it would have looked thirty times nearer to rest.
  system.cloth_mass.clear();
  EXPECT_LT(residual_of(system, force).norm, bare.norm / 30);
}

TEST(Residual, HeldParticlesWeighNothing) {
  ParticleSystem system = cloth_with_board();
  system.held = {0, 1, 1, 1};
  const particles::VectorField force = {Vec3(1e-3, 0, 0), Vec3::Ones(), Vec3::Ones(), Vec3::Ones()};
  EXPECT_NEAR(residual_of(system, force).norm, 0.1, 1e-12);
}

TEST(Residual, RestAsksForTheLargestForceToo) {
  ParticleSystem system;
  system.mass.assign(10000, 1e-3);
  system.gravity = 10;
  particles::VectorField force(10000, Vec3::Zero());
  force[7] = Vec3(0, 0.9e-3 * 0.01 * std::sqrt(10000.0), 0);  // all of ‖F‖ on one particle
  SettleOutcome outcome;
  constexpr double kAny = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(check_convergence(system, force, {1e-3, kAny}, outcome));
  EXPECT_NEAR(outcome.residual_max, 0.09, 1e-12);
  EXPECT_TRUE(check_convergence(system, force, {1e-3, 0.1}, outcome));
  EXPECT_FALSE(check_convergence(system, force, {1e-3, 0.05}, outcome));
}

}  // namespace
}  // namespace loosefit::solver

#include "loosefit/solver/inertia_term.h"

#include <gtest/gtest.h>

#include <limits>

namespace loosefit::solver {
namespace {

/// Two particles, the second one held.
struct TwoParticles {
  ParticleSystem system;
  particles::VectorField x{{0.1, -0.2, 0.3}, {1, 2, 3}}, target{{0.12, -0.25, 0.29}, {1.1, 2, 3}};
  TwoParticles() {
    system.mass = {0.3, 0.7};
    system.held = {0, 1};
  }
};

TEST(InertiaTerm, HasTheGradientOfItsEnergyAndLeavesOutWhatIsHeld) {
  TwoParticles two;
  const InertiaTerm term(two.system, two.target, 0.05);
  EXPECT_NEAR(term.energy(two.x),
              0.5 * 0.3 / (0.05 * 0.05) * (two.x[0] - two.target[0]).squaredNorm(), 1e-12);
  particles::VectorField g(2, Vec3::Zero());
  term.add_gradient(two.x, g);
  constexpr double kH = 1e-6;
  for (int i = 0; i < 2; ++i)
    for (int k = 0; k < 3; ++k) {
      particles::VectorField more = two.x, less = two.x;
      more[i][k] += kH;
      less[i][k] -= kH;
      EXPECT_NEAR(g[i][k], (term.energy(more) - term.energy(less)) / (2 * kH), 1e-7);
      EXPECT_EQ(term.gradient(i, two.x)[k], g[i][k]);
    }
  EXPECT_EQ(g[1], Vec3(Vec3::Zero()));
}

TEST(InertiaTerm, IsNothingWithoutEnd) {
  TwoParticles two;
  const InertiaTerm term(two.system, two.target, std::numeric_limits<double>::infinity());
  EXPECT_EQ(term.energy(two.x), 0);
  EXPECT_EQ(term.gradient(0, two.x), Vec3(Vec3::Zero()));
  EXPECT_EQ(term.per_dt2(), 0);
}

}  // namespace
}  // namespace loosefit::solver

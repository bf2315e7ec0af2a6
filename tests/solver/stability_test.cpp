#include "loosefit/solver/stability.h"

#include <gtest/gtest.h>

#include <cmath>

namespace loosefit::solver {
namespace {

/// Π = ½ Σ k_i |x_i|²: every particle on a spring of its own.
class Springs : public particles::Energy {
 public:
  explicit Springs(std::vector<double> stiffness) : k_(std::move(stiffness)) {}
  double value(const particles::VectorField& x) const override {
    double sum = 0;
    for (std::size_t i = 0; i < x.size(); ++i) sum += 0.5 * k_[i] * x[i].squaredNorm();
    return sum;
  }
  void add_gradient(const particles::VectorField& x, particles::VectorField& g) const override {
    for (std::size_t i = 0; i < x.size(); ++i) g[i] += k_[i] * x[i];
  }
  void add_pattern(const particles::VectorField&, particles::BlockPattern&) const override {}
  void add_hessian(const particles::VectorField& x, particles::BlockMatrix& h,
                   particles::HessianKind) const override {
    for (std::size_t i = 0; i < x.size(); ++i) {
      const int n = static_cast<int>(i);
      h.add(n, n, k_[i] * Mat3::Identity());
    }
  }

 private:
  std::vector<double> k_;
};

struct Scene {
  Springs springs;
  ParticleSystem system;
  particles::VectorField x;
  Scene(const std::vector<double>& k, const std::vector<double>& mass)
      : springs(k), x(k.size(), Vec3::Zero()) {
    system.energies = {&springs};
    system.mass = mass;
  }
};

TEST(Stability, OfSpringsIsThatAllOfThemPull) {
  const Scene pulling({3, 1, 2}, {1, 1, 1}), one_pushes({3, -1, 2}, {1, 1, 1});
  EXPECT_TRUE(is_stable(pulling.system, pulling.x));
  EXPECT_FALSE(is_stable(one_pushes.system, one_pushes.x));
  EXPECT_FALSE(lowest_unstable_mode(pulling.system, pulling.x).has_value());
}

TEST(Stability, HeldParticlesDoNotCount) {
  Scene scene({3, -1, 2}, {1, 1, 1});
  scene.system.held = {0, 1, 0};
  EXPECT_TRUE(is_stable(scene.system, scene.x));
}

TEST(Stability, LowestModeIsThatOfTheGreatestGrowthRateNotOfTheGreatestForce) {
  // −4 N/m on 2 kg grow slower than −1 N/m on 0.01 kg: λ = k/m = −2 and −100 /s².
  const Scene scene({5, -4, -1}, {1, 2, 0.01});
  const auto mode = lowest_unstable_mode(scene.system, scene.x);
  ASSERT_TRUE(mode.has_value());
  EXPECT_NEAR(mode->curvature, -100, 1);
  EXPECT_NEAR(mode->direction[2].norm(), 1, 1e-12);
  EXPECT_LT(mode->direction[0].norm(), 1e-3);
  EXPECT_LT(mode->direction[1].norm(), 0.1);
}

TEST(Stability, WhatNothingResistsIsNotUnstable) {
  const Scene free({1, 0}, {0.1, 0.1});
  EXPECT_TRUE(is_stable(free.system, free.x));
  EXPECT_FALSE(is_stable(free.system, free.x, {.neutral = 0}));
}

}  // namespace
}  // namespace loosefit::solver

#include "loosefit/solver/integrator.h"

#include <gtest/gtest.h>

#include <limits>

#include "loosefit/particles/energy_capabilities.h"
#include "loosefit/solver/implicit_euler.h"
#include "loosefit/solver/quasi_static.h"
#include "loosefit/solver/semi_implicit_euler.h"

namespace loosefit::solver {
namespace {

/// Every particle on its own spring to the origin, stiffness k [N/m], pulled by a constant force.
class Springs : public particles::Energy {
 public:
  explicit Springs(double k, const Vec3& pull = Vec3::Zero()) : k_(k), pull_(pull) {}
  double value(const particles::VectorField& x) const override {
    double e = 0;
    for (const Vec3& p : x) e += 0.5 * k_ * p.squaredNorm() - pull_.dot(p);
    return e;
  }
  void add_gradient(const particles::VectorField& x, particles::VectorField& g) const override {
    for (std::size_t i = 0; i < x.size(); ++i) g[i] += k_ * x[i] - pull_;
  }
  void add_pattern(const particles::VectorField&, particles::BlockPattern&) const override {}
  void add_hessian(const particles::VectorField& x, particles::BlockMatrix& h,
                   particles::HessianKind) const override {
    for (int i = 0; i < static_cast<int>(x.size()); ++i) h.add(i, i, k_ * Mat3::Identity());
  }

 private:
  double k_;
  Vec3 pull_;
};

ParticleSystem system_of(Springs& springs, int n, double mass) {
  ParticleSystem s;
  s.energies = {&springs};
  s.mass.assign(n, mass);
  return s;
}

// docs/theory/validation.md 7: cos(ω'dt) = 1 − (ω dt)²/2, and v²/2 + ω²x²/2 − (ω² dt/2) x v never
// drifts.
TEST(SemiImplicitEuler, OscillatesWithTheShiftedFrequencyAndConservesItsOwnEnergy) {
  const double k = 400, mass = 0.25, omega = std::sqrt(k / mass), dt = 0.3 / omega;
  Springs springs(k);
  const ParticleSystem system = system_of(springs, 1, mass);
  particles::VectorField x = {Vec3(0.01, 0, 0)}, v = {Vec3::Zero()};
  const auto conserved = [&] {
    return 0.5 * v[0].squaredNorm() + 0.5 * omega * omega * x[0].squaredNorm() -
           0.5 * omega * omega * dt * x[0].dot(v[0]);
  };
  // x_{n+1} − 2cosθ x_n + x_{n−1} = 0 with cosθ = 1 − (ω dt)²/2.
  const double theta = std::acos(1 - 0.5 * omega * omega * dt * dt);
  double before = x[0][0];
  semi_implicit_euler_step(system, x, v, dt);
  const double start = conserved();
  for (int i = 0; i < 10000; ++i) {
    const double now = x[0][0];
    semi_implicit_euler_step(system, x, v, dt);
    ASSERT_NEAR(x[0][0], 2 * std::cos(theta) * now - before, 1e-14);
    before = now;
  }
  EXPECT_NEAR(conserved(), start, 1e-9 * start);
}

TEST(Residual, IsTheForceOverTheWeightOfFreeParticles) {
  Springs springs(10, Vec3(0, 0, 3));
  ParticleSystem system = system_of(springs, 4, 0.1);
  system.held = {1, 0, 0, 0};
  const particles::VectorField x(4, Vec3::Zero());
  const Residual r = residual_of(system, system.gradient(x));
  EXPECT_NEAR(r.norm, 3 / (0.1 * kGravity), 1e-12);
  EXPECT_NEAR(r.largest, 3 / (0.1 * kGravity), 1e-12);
  EXPECT_GT(r.worst_particle, 0);  // not the held one
  system.gravity = 0;              // weightless: the force itself
  EXPECT_NEAR(residual_of(system, system.gradient(x)).norm, 3 * std::sqrt(3.0), 1e-12);
}

using Maker = std::unique_ptr<Integrator> (*)(const ParticleSystem&);
class EveryIntegrator : public ::testing::TestWithParam<Maker> {};

TEST_P(EveryIntegrator, FindsTheEquilibriumAndLeavesHeldParticles) {
  Springs springs(10, Vec3(0, 0.2, -1));
  ParticleSystem system = system_of(springs, 3, 0.1);
  system.held = {0, 1, 0};
  particles::VectorField x = {Vec3(0.1, 0, 0), Vec3(0.3, 0.3, 0.3), Vec3(-0.2, 0.1, 0)};
  SettleOptions options;
  options.tolerance = 1e-6;
  options.max_iterations = 100000;
  const auto outcome = GetParam()(system)->settle(x, options);
  EXPECT_EQ(outcome.reason, SettleOutcome::Reason::converged) << outcome.text();
  EXPECT_LE(outcome.residual, 1e-6);
  EXPECT_LT((x[0] - Vec3(0, 0.02, -0.1)).norm(), 1e-6);
  EXPECT_EQ((x[1] - Vec3(0.3, 0.3, 0.3)).norm(), 0);
}

TEST_P(EveryIntegrator, StopsAtTheIterationLimitAndWhenAsked) {
  Springs springs(10, Vec3(0, 0.2, -1));
  const ParticleSystem system = system_of(springs, 2, 0.1);
  SettleOptions options;
  options.tolerance = 1e-300;
  options.max_iterations = 2;
  particles::VectorField x = {Vec3(0.1, 0, 0), Vec3(-0.2, 0.1, 0)};
  auto outcome = GetParam()(system)->settle(x, options);
  EXPECT_NE(outcome.reason, SettleOutcome::Reason::converged);
  EXPECT_NE(outcome.reason, SettleOutcome::Reason::stopped);
  options.max_iterations = 100000;
  int asked = 0;
  options.watch = [&](int, double) { return ++asked == 1; };
  x = {Vec3(0.1, 0, 0), Vec3(-0.2, 0.1, 0)};
  outcome = GetParam()(system)->settle(x, options);
  EXPECT_EQ(outcome.reason, SettleOutcome::Reason::stopped);
  EXPECT_EQ(outcome.text(), "time budget");
  EXPECT_EQ(asked, 1);
}

INSTANTIATE_TEST_SUITE_P(Kinds, EveryIntegrator,
                         ::testing::Values(
                             +[](const ParticleSystem& s) { return make_quasi_static(s); },
                             +[](const ParticleSystem& s) { return make_implicit_euler(s); },
                             +[](const ParticleSystem& s) { return make_semi_implicit_euler(s); }));

/// A spring whose anchor is lagged and jumps to the other side: static iterates mirror x for ever.
class MirroredSpring : public particles::Energy, public particles::LaggedState {
 public:
  void begin_step(const particles::VectorField& x, double) override { anchor_ = -x[0]; }
  double value(const particles::VectorField& x) const override {
    return 0.5 * (x[0] - anchor_).squaredNorm();
  }
  void add_gradient(const particles::VectorField& x, particles::VectorField& g) const override {
    g[0] += x[0] - anchor_;
  }
  void add_pattern(const particles::VectorField&, particles::BlockPattern&) const override {}
  void add_hessian(const particles::VectorField&, particles::BlockMatrix& h,
                   particles::HessianKind) const override {
    h.add(0, 0, Mat3::Identity());
  }

 private:
  Vec3 anchor_ = Vec3::Zero();
};

TEST(QuasiStatic, DampsWhatStaticStepsOnlySendToAndFro) {
  MirroredSpring spring;
  ParticleSystem system;
  system.energies = {&spring};
  system.mass = {1.0};
  particles::VectorField x = {Vec3(0.01, 0, 0)};
  SettleOptions options;
  options.tolerance = 1e-6;
  options.first_dt = 1e4;
  const SettleOutcome outcome = make_quasi_static(system)->settle(x, options);
  EXPECT_EQ(outcome.reason, SettleOutcome::Reason::converged);
  EXPECT_LT(x[0].norm(), 1e-5);
}

}  // namespace
}  // namespace loosefit::solver

#include <gtest/gtest.h>

#include "loosefit/fabric/bending_energy.h"
#include "loosefit/fabric/membrane_energy.h"
#include "loosefit/particles/gravity_energy.h"
#include "loosefit/solver/implicit_euler.h"
#include "loosefit/solver/integrator.h"
#include "loosefit/solver/quasi_static.h"
#include "loosefit/solver/semi_implicit_euler.h"
#include "support/flat_garment.h"

namespace loosefit::drape {
namespace {

/// A rectangular strip clamped along y = top (hanging) or x = 0 (cantilever), with its energies.
struct Strip {
  geometry::TriangleMesh mesh;
  std::unique_ptr<fabric::MembraneEnergy> membrane;
  std::unique_ptr<fabric::BendingEnergy> bending;
  std::unique_ptr<particles::GravityEnergy> gravity;
  solver::ParticleSystem system;
  particles::VectorField x;

  Strip(double width, double height, double edge, const fabric::Material& m, double jitter = 0.1,
        bool viscous = false)
      : mesh(support::sheet(width, height, edge, jitter)) {
    const auto uv = support::flat_uv(mesh);
    membrane = std::make_unique<fabric::MembraneEnergy>(mesh.triangles, uv, std::vector<double>{},
                                                        m, viscous);
    bending = std::make_unique<fabric::BendingEnergy>(mesh.triangles, uv, std::vector<double>{}, m,
                                                      viscous);
    system.mass = support::lumped_mass(mesh, m.areal_density);
    gravity = std::make_unique<particles::GravityEnergy>(system.mass, kGravity);
    system.energies = {membrane.get(), bending.get(), gravity.get()};
    system.held.assign(system.mass.size(), 0);
    x = mesh.vertices;
  }
};

// docs/theory/validation.md 6.1: St. Venant-Kirchhoff strip under its own weight, w = 0.2 kg/m².
struct HangingCase {
  double stiffness, length, elongation, top_stretch;
};
class HangingStrip : public ::testing::TestWithParam<HangingCase> {};

TEST_P(HangingStrip, ElongatesAsTheClosedForm) {
  const HangingCase& c = GetParam();
  fabric::Material m;
  m.areal_density = 0.2;
  m.stiffness_warp = m.stiffness_weft = c.stiffness;
  m.poisson = 0;
  m.stiffness_shear = c.stiffness / 2;
  Strip strip(0.1, c.length, 0.02, m);
  // The pattern's warp hangs along −z from y = length.
  for (std::size_t i = 0; i < strip.x.size(); ++i) {
    const Vec3 p = strip.mesh.vertices[i];
    strip.system.held[i] = p[1] > c.length - 1e-9;
    strip.x[i] = Vec3(p[0], 0, p[1]);
  }
  solver::SettleOptions options;
  options.tolerance = 1e-8;
  const solver::SettleOutcome outcome =
      solver::make_quasi_static(strip.system)->settle(strip.x, options);
  EXPECT_EQ(outcome.reason, solver::SettleOutcome::Reason::converged)
      << outcome.text() << outcome.residual;
  double lowest = 0;
  int count = 0;
  for (std::size_t i = 0; i < strip.x.size(); ++i)
    if (strip.mesh.vertices[i][1] < 1e-9) {
      lowest += -strip.x[i][2];
      ++count;
    }
  EXPECT_NEAR(lowest / count, c.elongation, 0.02 * c.elongation);
}

INSTANTIATE_TEST_SUITE_P(Validation61, HangingStrip,
                         ::testing::Values(HangingCase{50, 1.0, 0.01889874, 1.03713273},
                                           HangingCase{20, 1.0, 0.04497991, 1.08651536},
                                           HangingCase{200, 0.6, 0.00175493, 1.00583286}));

// docs/theory/validation.md 7: x_n = −g dt² n(n+1)/2, exact for the paper's integrator.
TEST(SemiImplicitEuler, FreeFallIsExact) {
  Strip strip(0.02, 0.02, 0.01, fabric::Material{});
  particles::VectorField v(strip.x.size(), Vec3::Zero());
  const double dt = 1e-5;
  const int n = 200;
  for (int i = 0; i < n; ++i) solver::semi_implicit_euler_step(strip.system, strip.x, v, dt);
  for (std::size_t i = 0; i < strip.x.size(); ++i)
    EXPECT_NEAR(strip.x[i][2], -kGravity * dt * dt * n * (n + 1) / 2, 1e-13);
}

TEST(Integrators, AgreeOnTheEquilibriumOfASmallDrape) {
  fabric::Material m;
  m.stiffness_warp = m.stiffness_weft = 60;
  m.stiffness_shear = 25;
  m.bending_warp = m.bending_weft = 2e-5;
  m.damping = 0.005;
  std::vector<particles::VectorField> rest;
  std::vector<double> energy;
  for (int kind = 0; kind < 3; ++kind) {
    if (kind == 2) m.damping = 2e-5;  // explicit viscosity must stay below the stable step
    Strip strip(0.06, 0.06, 0.012, m, 0.1, true);
    for (std::size_t i = 0; i < strip.x.size(); ++i)
      strip.system.held[i] = strip.mesh.vertices[i][0] < 0.015;
    auto integrator = kind == 0   ? solver::make_quasi_static(strip.system)
                      : kind == 1 ? solver::make_implicit_euler(strip.system)
                                  : solver::make_semi_implicit_euler(strip.system);
    solver::SettleOptions options;
    options.tolerance = 1e-5;
    options.first_dt = 0.02;
    options.max_iterations = kind == 2 ? 2000000 : 3000;
    const solver::SettleOutcome outcome = integrator->settle(strip.x, options);
    EXPECT_EQ(outcome.reason, solver::SettleOutcome::Reason::converged)
        << kind << " " << outcome.text() << " " << outcome.residual;
    strip.system.begin_step(strip.x, std::numeric_limits<double>::infinity());
    energy.push_back(strip.system.potential(strip.x));
    rest.push_back(strip.x);
  }
  for (int kind = 1; kind < 3; ++kind) {
    EXPECT_NEAR(energy[kind], energy[0], 1e-6 * std::abs(energy[0]));
    for (std::size_t i = 0; i < rest[0].size(); ++i)
      EXPECT_LT((rest[kind][i] - rest[0][i]).norm(), 2e-5);
  }
}

}  // namespace
}  // namespace loosefit::drape

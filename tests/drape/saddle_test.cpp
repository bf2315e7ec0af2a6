#include <gtest/gtest.h>

#include "loosefit/drape/cloth_state.h"
#include "loosefit/drape/phases/certify_state.h"
#include "loosefit/drape/recoveries.h"
#include "loosefit/fabric/bending_energy.h"
#include "loosefit/fabric/membrane_energy.h"
#include "loosefit/garment/assemble.h"
#include "loosefit/particles/gravity_energy.h"
#include "loosefit/solver/quasi_static.h"
#include "loosefit/solver/stability.h"
#include "support/flat_garment.h"
#include "support/shapes.h"
#include "support/simple_patterns.h"

namespace loosefit::drape {
namespace {

/// An upright strip under its own weight, clamped at its foot: the column of Greenhill (1881),
/// which is stable up to w g L³/B = 7.837. Straight it is balanced under any load.
struct Column {
  static constexpr double kWidth = 0.02, kLength = 0.1, kEdge = 0.005;
  fabric::Material material;
  geometry::TriangleMesh mesh = support::sheet(kWidth, kLength, kEdge);
  std::unique_ptr<fabric::MembraneEnergy> membrane;
  std::unique_ptr<fabric::BendingEnergy> bending;
  std::unique_ptr<particles::GravityEnergy> gravity;
  solver::ParticleSystem system;
  particles::VectorField x;

  explicit Column(double load_number) {
    material.poisson = material.bending_poisson = 0;
    material.stiffness_warp = material.stiffness_weft = 2e4;
    const double free_length = kLength - kEdge;  // the two lowest rows are held
    material.bending_warp = material.bending_weft =
        material.areal_density * kGravity * std::pow(free_length, 3) / load_number;
    const auto uv = support::flat_uv(mesh);
    membrane = std::make_unique<fabric::MembraneEnergy>(mesh.triangles, uv, std::vector<double>{},
                                                        material, false);
    bending = std::make_unique<fabric::BendingEnergy>(mesh.triangles, uv, std::vector<double>{},
                                                      material, false);
    system.mass = support::lumped_mass(mesh, material.areal_density);
    gravity = std::make_unique<particles::GravityEnergy>(system.mass, kGravity);
    system.energies = {membrane.get(), bending.get(), gravity.get()};
    for (const Vec3& p : mesh.vertices) {
      x.emplace_back(p[0], 0, p[1]);
      system.held.push_back(p[1] < 1.5 * kEdge);
    }
  }
  void settle(double tolerance = 1e-7) {
    solver::SettleOptions options;
    options.tolerance = tolerance;
    const auto outcome = solver::make_quasi_static(system)->settle(x, options);
    ASSERT_EQ(outcome.reason, solver::SettleOutcome::Reason::converged) << outcome.residual;
  }
  double top() const {
    double top = 0;
    for (const Vec3& p : x) top = std::max(top, p[2]);
    return top;
  }
  double sideways() const {
    double most = 0;
    for (const Vec3& p : x) most = std::max(most, std::abs(p[1]));
    return most;
  }
};

TEST(Saddle, AColumnIsStableBelowItsCriticalHeightAndASaddleAbove) {
  for (const double load_number : {4.0, 6.5, 9.5, 30.0}) {
    Column column(load_number);
    column.settle();
    ASSERT_LT(column.sideways(), 1e-9) << load_number;
    EXPECT_EQ(solver::is_stable(column.system, column.x), load_number < 7.837) << load_number;
  }
}

TEST(Saddle, ModeOfAColumnLeansSidewaysAndLosesEnergyToBothSides) {
  Column column(12);
  column.settle();
  const auto mode = solver::lowest_unstable_mode(column.system, column.x);
  ASSERT_TRUE(mode.has_value());
  EXPECT_LT(mode->curvature, 0);
  const double straight = column.system.potential(column.x);
  for (const double length : {1e-4, -1e-4}) {  // farther off it would be stretched
    particles::VectorField leaning = column.x;
    for (std::size_t i = 0; i < leaning.size(); ++i) leaning[i] += length * mode->direction[i];
    EXPECT_LT(column.system.potential(leaning), straight);
  }
  // Clamped below, all to one side and most at the top.
  for (std::size_t i = 0; i < column.x.size(); ++i) {
    EXPECT_LT(std::abs(mode->direction[i][0]), 0.05);
    if (column.system.held[i]) {
      EXPECT_EQ(mode->direction[i].norm(), 0);
    } else if (column.x[i][2] > 0.9 * Column::kLength) {
      EXPECT_GT(mode->direction[i].norm(), 0.8);
    }
  }
}

TEST(Saddle, LeftAlongItsModeTheColumnComesToRestHangingOver) {
  Column column(60);
  column.settle();
  const double straight = column.top();
  const auto mode = solver::lowest_unstable_mode(column.system, column.x);
  ASSERT_TRUE(mode.has_value());
  for (std::size_t i = 0; i < column.x.size(); ++i) column.x[i] += 1e-3 * mode->direction[i];
  column.settle(1e-4);
  EXPECT_TRUE(solver::is_stable(column.system, column.x));
  EXPECT_GT(column.sideways(), 0.25 * Column::kLength);
  EXPECT_LT(column.top(), 0.9 * straight);
}

/// A column of cloth as a drape on its finest level, over a ball that it does not reach.
struct StandingCloth {
  garment::GarmentHierarchy garment;
  std::vector<ClothLayer> layers{{&garment, {}}};
  DrapeOptions options;
  Progress silent;
  ClothState state{layers, options, recoveries(), silent};

  explicit StandingCloth(double height) {
    pattern::Pattern pattern;
    pattern.panels = {testing_support::rectangle_panel("cloth", 0.02, height)};
    garment.levels = {garment::assemble(pattern, 0.005, {})};
    for (const Vec2& uv : garment.finest().vertex_uv) state.x.emplace_back(uv[0], 0, uv[1] + 0.2);
    body::Body ball;
    ball.surface = support::sphere(0.1, 24, 48);
    ball.segment.assign(ball.surface.vertices.size(), body::Segment::torso);
    ball.side.assign(ball.surface.vertices.size(), 0);
    state.body = with_field(std::move(ball), bounds(state.x), 0.005);
    state.make_model();
    for (const Vec3& p : state.x) state.model->system().held.push_back(p[2] < 0.2076);
    state.settle({1e-6, kNoLimit, 0.01});
  }
  double sideways() const {
    double most = 0;
    for (const Vec3& p : state.x) most = std::max(most, std::abs(p[1]));
    return most;
  }
};

TEST(Saddle, TheRecoveryLeavesItAndTheCertificateSaysStable) {
  StandingCloth cloth(0.06);  // twice the critical height of this cotton
  measure_certificate(cloth.state);
  ASSERT_TRUE(cloth.state.certificate.settled());
  ASSERT_LT(cloth.sideways(), 1e-9);
  EXPECT_EQ(cloth.state.certificate.stable, false);
  certify_state(cloth.state);
  EXPECT_TRUE(cloth.state.report.was_tried(RecoveryKind::leave_saddle));
  EXPECT_TRUE(cloth.state.certificate.settled());
  EXPECT_EQ(cloth.state.certificate.stable, true);
  EXPECT_GT(cloth.sideways(), 0.01);
}

TEST(Saddle, AStableDrapeIsLeftAsItIs) {
  StandingCloth cloth(0.03);
  const std::vector<Vec3> before = cloth.state.x;
  certify_state(cloth.state);
  EXPECT_EQ(cloth.state.certificate.stable, true);
  EXPECT_FALSE(cloth.state.report.was_tried(RecoveryKind::leave_saddle));
  EXPECT_EQ(cloth.state.x, before);
}

}  // namespace
}  // namespace loosefit::drape

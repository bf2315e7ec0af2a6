#include "loosefit/solver/region_relaxation.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <limits>
#include <numeric>

#include "loosefit/contact/self_contact.h"
#include "loosefit/solver/newton.h"
#include "loosefit/solver/quasi_static.h"
#include "support/cloth_scene.h"
#include "support/shapes.h"

namespace loosefit::drape {
namespace {

constexpr double kStatic = std::numeric_limits<double>::infinity();

/// A sheet that hangs from its upper edge, with contact with itself; at rest but for a dent in one
/// place.
struct DentedSheet {
  geometry::TriangleMesh mesh = support::sheet(0.3, 0.3, 0.012, 0.2);
  support::ClothScene scene{
      mesh, {}, hanging(mesh), support::box_mesh(Vec3::Constant(0.01)), fabric::Material{}, {}};
  contact::SelfContact self{scene.triangles, scene.area, static_cast<int>(scene.x.size()), {}};
  int dent = 0;

  static particles::VectorField hanging(const geometry::TriangleMesh& mesh) {
    particles::VectorField x;
    for (const Vec3& p : mesh.vertices) x.emplace_back(p[0], 0.1, p[1]);
    return x;
  }
  DentedSheet() {
    scene.system.energies.push_back(&self);
    for (std::size_t i = 0; i < scene.x.size(); ++i)
      scene.system.held[i] = mesh.vertices[i][1] > 0.3 - 1e-9;
    solver::SettleOptions options;
    options.tolerance = 1e-6;
    const auto outcome = solver::make_quasi_static(scene.system)->settle(scene.x, options);
    EXPECT_EQ(outcome.reason, solver::SettleOutcome::Reason::converged) << outcome.text();
    for (std::size_t i = 0; i < scene.x.size(); ++i)
      if ((mesh.vertices[i] - Vec3(0.15, 0.15, 0)).norm() <
          (mesh.vertices[dent] - Vec3(0.15, 0.15, 0)).norm())
        dent = static_cast<int>(i);
    scene.x[dent] += Vec3(0, 2e-3, 0);
    scene.system.begin_step(scene.x, kStatic);
  }
};

/// Relaxes the region of the dent once.
struct Relaxed {
  particles::VectorField x, force,
      left;              ///< force: of potential and inertia before [N], left: after
  double before, after;  ///< potential [J]
  solver::ResidualRegion region;
  int steps = 0;

  Relaxed(const DentedSheet& sheet, const particles::VectorField& target, double dt)
      : x(sheet.scene.x) {
    const solver::ParticleSystem& system = sheet.scene.system;
    const solver::InertiaTerm inertia(system, target, dt);
    const auto force_at = [&](const particles::VectorField& place) {
      particles::VectorField g = system.gradient(place);
      inertia.add_gradient(place, g);
      return g;
    };
    solver::TangentMatrix tangent(system);
    tangent.assemble(x, particles::HessianKind::projected);
    force = force_at(x);
    before = system.potential(x);
    region = solver::residual_region(tangent.matrix(), force, {});
    std::vector<int> order(x.size());
    std::iota(order.begin(), order.end(), 0);
    solver::RegionRelaxation relaxation(system);
    steps = relaxation.relax(x, force, inertia, 0.02, order, tangent).value_or(0);
    left = force_at(x);
    after = system.potential(x);
  }
  /// Of the squared force in the region.
  double share_left() const {
    double now = 0, then = 0;
    for (int i : region.particles) {
      now += left[i].squaredNorm();
      then += force[i].squaredNorm();
    }
    return now / then;
  }
};

TEST(RegionRelaxation, TakesTheForceAwayAndMovesNothingElse) {
  const DentedSheet sheet;
  const Relaxed relaxed(sheet, sheet.scene.x, kStatic);
  ASSERT_FALSE(relaxed.region.empty());
  ASSERT_GE(relaxed.region.index[sheet.dent], 0);
  ASSERT_LT(relaxed.region.particles.size(), relaxed.x.size() / 6);
  EXPECT_GT(relaxed.steps, 0);
  EXPECT_LT(relaxed.after, relaxed.before);
  for (std::size_t i = 0; i < relaxed.x.size(); ++i)
    if (relaxed.region.index[i] < 0) {
      EXPECT_EQ(relaxed.x[i], sheet.scene.x[i]);
    }
  EXPECT_LT(relaxed.share_left(), 0.01);
}

TEST(RegionRelaxation, BalancesInertiaToo) {
  const DentedSheet sheet;
  particles::VectorField target = sheet.scene.x;
  target[sheet.dent] -= Vec3(0, 2e-3, 0);
  const Relaxed relaxed(sheet, target, 1e-4);  // about as stiff as the membrane
  ASSERT_FALSE(relaxed.region.empty());
  EXPECT_GT(relaxed.steps, 0);
  EXPECT_LT(relaxed.share_left(), 0.01);
}

TEST(RegionRelaxation, MovesNothingThatIsHeld) {
  DentedSheet sheet;
  const int held = sheet.dent + 1;
  sheet.scene.system.held[held] = true;
  const Relaxed relaxed(sheet, sheet.scene.x, kStatic);
  ASSERT_GE(relaxed.region.index[held], 0);
  EXPECT_GT(relaxed.steps, 0);
  EXPECT_LT(relaxed.after, relaxed.before);
  EXPECT_EQ(relaxed.x[held], sheet.scene.x[held]);
  EXPECT_NE(relaxed.x[sheet.dent], sheet.scene.x[sheet.dent]);
}

struct Way {
  particles::VectorField x;
  int iterations = 0, regional = 0;
};

/// Newton until the force is below a millionth of the weight.
Way way_down(int min_particles) {
  DentedSheet sheet;
  solver::SolverTuning tuning;
  tuning.region.min_particles = min_particles;
  solver::Newton newton(sheet.scene.system, tuning);
  Way way{sheet.scene.x};
  for (; way.iterations < 100; ++way.iterations) {
    if (solver::residual_of(sheet.scene.system, newton.gradient(way.x)).norm < 1e-6) break;
    if (!newton.iterate(way.x, way.x, kStatic).moved) break;
  }
  way.regional = newton.work().regional;
  EXPECT_LT(solver::residual_of(sheet.scene.system, newton.gradient(way.x)).norm, 1e-6);
  return way;
}

TEST(Newton, FindsTheSameRestWithAndWithoutRegionsInAboutAsMany) {
  const Way plain = way_down(std::numeric_limits<int>::max()), regional = way_down(0);
  EXPECT_EQ(plain.regional, 0);
  EXPECT_GT(regional.regional, 0);
  EXPECT_LE(regional.iterations, plain.iterations + 1);
  for (std::size_t i = 0; i < plain.x.size(); ++i)
    EXPECT_LT((plain.x[i] - regional.x[i]).norm(), 1e-5);
}

TEST(Newton, WithRegionsGivesTheSameBitsWithOneThread) {
  tbb::task_arena arena(4);
  const Way many = arena.execute([] { return way_down(0); });
  EXPECT_GT(many.regional, 0);
  const tbb::global_control single(tbb::global_control::max_allowed_parallelism, 1);
  const Way one = way_down(0);
  EXPECT_EQ(many.x, one.x);
  EXPECT_EQ(many.iterations, one.iterations);
}

}  // namespace
}  // namespace loosefit::drape

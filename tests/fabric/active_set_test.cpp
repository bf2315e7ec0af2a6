#include <gtest/gtest.h>

#include "loosefit/fabric/bending_energy.h"
#include "loosefit/fabric/membrane_energy.h"
#include "support/active_set_checker.h"
#include "support/flat_garment.h"

namespace loosefit::fabric {
namespace {

constexpr particles::HessianKind kKinds[] = {particles::HessianKind::exact,
                                             particles::HessianKind::half_compression,
                                             particles::HessianKind::projected};

/// A folded sheet of several tiles, mid-way in a time step.
struct Sheet {
  geometry::TriangleMesh mesh = support::sheet(0.2, 0.2, 0.01, 0.2);
  std::vector<std::array<Vec2, 3>> uv = support::flat_uv(mesh);
  particles::VectorField x = mesh.vertices;
  particles::ActiveSet active_set = support::two_groups(static_cast<int>(x.size()));
  Sheet() {
    for (Vec3& p : x) p[2] += 0.01 * std::sin(90 * p[0]) * std::cos(70 * p[1]);
  }
};

TEST(MembraneEnergy, InAnActiveSetItsForcesAndStiffnessAreThoseOfTheWhole) {
  const Sheet sheet;
  Material stiff, limp;
  stiff.bending_warp = stiff.bending_weft = 1;  // does not buckle
  for (const Material& m : {stiff, limp}) {
    MembraneEnergy membrane(sheet.mesh.triangles, sheet.uv, {}, m, true);
    membrane.begin_step(sheet.mesh.vertices, 0.01);
    for (particles::HessianKind kind : kKinds)
      EXPECT_GT(support::expect_same_in_active_set(membrane, sheet.x, sheet.active_set, 1e-3, kind),
                0);
  }
}

TEST(BendingEnergy, InAnActiveSetItsForcesAndStiffnessAreThoseOfTheWhole) {
  const Sheet sheet;
  Material m;
  m.bending_hysteresis_warp = m.bending_hysteresis_weft = 1e-4;
  BendingEnergy bending(sheet.mesh.triangles, sheet.uv, {}, m, true);
  bending.begin_step(sheet.mesh.vertices, 0.01);
  for (particles::BendingTangent tangent :
       {particles::BendingTangent::hinge, particles::BendingTangent::plate}) {
    bending.set_tangent(tangent);
    for (particles::HessianKind kind : kKinds)
      EXPECT_GT(support::expect_same_in_active_set(bending, sheet.x, sheet.active_set, 1e-3, kind),
                0);
  }
}

TEST(CurvaturePatches, HingesFollowTheOrderOfTheirTriangles) {
  const Sheet sheet;
  const std::vector<Mat3> rigidity(sheet.mesh.triangles.size(), Mat3::Identity());
  const CurvaturePatches patches = curvature_patches(sheet.mesh.triangles, sheet.uv, rigidity, {});
  int known = 0;
  for (const CurvaturePatch& p : patches.patches) {
    int most = known;
    for (int k = 0; k < 3; ++k) most = std::max(most, p.hinge[k] + 1);
    EXPECT_LE(most, known + 3);
    known = most;
  }
  EXPECT_EQ(known, static_cast<int>(patches.hinges.size()));
}

}  // namespace
}  // namespace loosefit::fabric

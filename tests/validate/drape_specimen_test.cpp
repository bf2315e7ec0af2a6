#include "loosefit/validate/drape_specimen.h"

#include <gtest/gtest.h>

#include <cmath>

namespace loosefit::validate {
namespace {

const DrapeTester kTester;

/// Isotropic sheet of bending length c [m].
fabric::Material sheet(double c) {
  fabric::Material m;
  m.areal_density = 0.12;
  m.stiffness_warp = m.stiffness_weft = 300;
  m.poisson = 0;
  m.stiffness_shear = 150;
  m.bending_warp = m.bending_weft = m.areal_density * kGravity * c * c * c;
  return m;
}

/// Settled from a start with so many folds, its weight let on in `steps` equal steps.
DrapeReading draped(const fabric::Material& m, int folds, double lean, double swing, int steps = 1,
                    double edge = 0.015) {
  Bench bench(cut_drape_specimen(kTester, edge, m), m, folded_start(kTester, folds, lean, swing));
  bench.hold(on_disc(bench.specimen(), kTester));
  Progress silent;
  for (int k = 1; k <= steps; ++k) {
    for (int v = 0; v < bench.specimen().vertex_count; ++v)
      bench.loads().force[v] =
          Vec3(0, 0, (1 - double(k) / steps) * kGravity * bench.specimen().vertex_mass[v]);
    settle_bench(bench, silent, 1e-4);
  }
  return read_drape(bench, kTester);
}

TEST(DrapeSpecimen, isFlatAsABoardAndHangsWhenLimp) {
  EXPECT_GT(draped(sheet(0.10), 6, 0.6, 0.35).coefficient, 0.995);
  const double stiff = draped(sheet(0.03), 6, 0.6, 0.35).coefficient;
  const double limp = draped(sheet(0.015), 6, 0.6, 0.35).coefficient;
  EXPECT_GT(stiff, limp + 0.3);
  EXPECT_GT(limp, 0.2);
}

TEST(DrapeSpecimen, stiffRingSagsLikeAClampedPlate) {
  // Rim deflection of an annulus clamped inside, a/b = 0.6, ν = 0 (docs/theory/validation.md 4.9).
  fabric::Material m = sheet(0.3);
  m.bending_poisson = 0;
  Bench bench(cut_drape_specimen(kTester, 0.006, m), m,
              [](const Vec2& p) { return Vec3(p[0], p[1], 0); });
  bench.hold(on_disc(bench.specimen(), kTester));
  Progress silent;
  settle_bench(bench, silent, 1e-8);
  double sag = 0;
  int count = 0;
  for (int v : vertices_where(bench.specimen(), [](const Vec2& p) {
         return p.norm() > kTester.specimen_radius - 1e-6;
       }))
    sag -= bench.x[v][2], ++count;
  const double expected = 0.00383351 * m.areal_density * kGravity *
                          std::pow(kTester.specimen_radius, 4) / m.bending_warp;
  EXPECT_NEAR(sag / count / expected, 1, 0.04);
}

TEST(DrapeSpecimen, keepsTheFoldsOfItsStart) {
  for (int folds : {6, 7}) {
    const DrapeReading r = draped(sheet(0.015), folds, 0.6, 0.35, 1, 0.011);
    EXPECT_EQ(r.folds.count, folds);
    EXPECT_GT(r.folds.share, 0.7) << "nearly equal folds";
    EXPECT_GT(r.folds.amplitude, 0.01);
  }
}

TEST(DrapeSpecimen, bendingFrictionHoldsTheClothUp) {
  fabric::Material m = sheet(0.02);
  const double elastic = draped(m, 6, 0, 0.01, 5).coefficient;
  m.bending_hysteresis_warp = m.bending_hysteresis_weft = 50 * m.bending_warp;  // κ_res = 50/m
  EXPECT_GT(draped(m, 6, 0, 0.01, 5).coefficient, elastic + 0.05);
}

}  // namespace
}  // namespace loosefit::validate

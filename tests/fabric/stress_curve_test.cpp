#include "loosefit/fabric/stress_curve.h"

#include <gtest/gtest.h>

#include <cmath>

#include "loosefit/base/error.h"
#include "support/wool_sample.h"

namespace loosefit::fabric {
namespace {

double green(double stretch) { return (stretch * stretch - 1) / 2; }

std::string refusal(const std::vector<CurvePoint>& points) {
  try {
    StressCurve::tension(points);
  } catch (const InvalidInput& e) {
    return std::string(e.what()) + " | " + e.hint();
  }
  return "accepted";
}

// docs/theory/validation.md 1.2: the engineering law f = C (λ − 1) is met at every stretch, also
// beyond the last point; at λ = 1.5 it is 0.5 C where St. Venant-Kirchhoff gives 0.9375 C.
TEST(TensionCurve, EngineeringLawIsExactAtEveryStretch) {
  const double c = 400;
  const StressCurve curve = StressCurve::tension({{0.1, 0.1 * c}, {0.3, 0.3 * c}, {0.5, 0.5 * c}});
  for (double stretch : {1.0, 1.0000001, 1.05, 1.1, 1.27, 1.5, 1.9}) {
    const StressCurve::Response r = curve.at(green(stretch));
    EXPECT_NEAR(r.stress * stretch, c * (stretch - 1), 1e-12 * c) << stretch;
    EXPECT_NEAR(r.energy, c * (stretch - 1) * (stretch - 1) / 2, 1e-12 * c) << stretch;
    EXPECT_NEAR(r.tangent, c / std::pow(stretch, 3), 1e-9 * c) << stretch;
  }
  EXPECT_DOUBLE_EQ(curve.at(0).tangent, c);
  EXPECT_NEAR(curve.smallest_tangent(), c / std::pow(1.5, 3), 1e-9 * c);
  EXPECT_NEAR(StressCurve::linear(c).at(green(1.5)).stress * 1.5, 0.9375 * c, 1e-12 * c);
}

TEST(TensionCurve, MeetsEveryMeasuredPoint) {
  const Material wool = support::wool_sample();
  const auto check = [](const StressCurve& curve, const std::vector<CurvePoint>& points) {
    for (const CurvePoint& p : points)
      EXPECT_NEAR(curve.at(p.strain).stress, p.force, 1e-11 * p.force) << p.strain;
  };
  check(StressCurve::tension(wool.curve_weft), support::wool_weft_green());
  check(StressCurve::tension(wool.curve_warp), support::wool_warp_green());
  check(StressCurve::shear(wool.curve_shear), support::wool_shear());
  // docs/theory/materials.md 4: initial slopes.
  EXPECT_NEAR(StressCurve::tension(wool.curve_weft).at(0).tangent, 366, 5);
  EXPECT_NEAR(StressCurve::tension(wool.curve_warp).at(0).tangent, 16400, 100);
  EXPECT_NEAR(StressCurve::shear(wool.curve_shear).at(0).tangent, 100, 1e-9);
}

// Stress is the derivative of the energy and the tangent that of the stress, at the points, between
// them, beyond them and in compression.
TEST(StressCurve, EnergyStressAndTangentAgree) {
  const Material wool = support::wool_sample();
  const StressCurve curves[] = {StressCurve::tension(wool.curve_weft),
                                StressCurve::tension(wool.curve_warp),
                                StressCurve::shear(wool.curve_shear),
                                StressCurve::tension({{0.1, 50}, {0.4, 60}, {1.0, 61}})};
  for (const StressCurve& curve : curves)
    for (double e = -0.1351; e < 0.9; e += 0.0037) {
      const double h = 1e-6;
      const StressCurve::Response r = curve.at(e), a = curve.at(e - h), b = curve.at(e + h);
      EXPECT_NEAR((b.energy - a.energy) / (2 * h), r.stress, 1e-6 * (std::abs(r.stress) + 10)) << e;
      EXPECT_NEAR((b.stress - a.stress) / (2 * h), r.tangent, 2e-3 * (std::abs(r.tangent) + 10))
          << e;
    }
}

TEST(StressCurve, IsSmoothAcrossTheOriginAndTheLastPoint) {
  const Material wool = support::wool_sample();
  const StressCurve curve = StressCurve::tension(wool.curve_weft);
  for (double e : {0.0, support::wool_weft_green()[3].strain, 0.1142}) {
    const StressCurve::Response a = curve.at(e - 1e-12), b = curve.at(e + 1e-12);
    EXPECT_NEAR(a.stress, b.stress, 1e-6);
    EXPECT_NEAR(a.tangent, b.tangent, 1e-4 * b.tangent);
  }
  EXPECT_EQ(curve.at(0).stress, 0);
  EXPECT_EQ(curve.at(0).energy, 0);
}

TEST(StressCurve, RisesWithEveryStrainWhenTheForceDoes) {
  const std::vector<CurvePoint> steps = {{0.01, 1},  {0.02, 100}, {0.03, 101},
                                         {0.2, 102}, {0.21, 900}, {0.9, 901}};
  const MonotoneCubic law(steps);
  double before = 0;
  for (double x = 1e-4; x < 1.5; x += 1e-4) {
    const double f = law.at(x).value;
    EXPECT_GT(f, before) << x;
    EXPECT_GT(law.at(x).slope, -1e-9) << x;
    before = f;
  }
}

TEST(CompressionAndShear, AreLinearAndOdd) {
  const Material wool = support::wool_sample();
  const StressCurve weft = StressCurve::tension(wool.curve_weft);
  EXPECT_NEAR(weft.at(-0.02).stress, -0.02 * weft.at(0).tangent, 1e-12);
  const StressCurve shear = StressCurve::shear(wool.curve_shear);
  for (double g : {0.004, 0.06, 0.3}) {
    EXPECT_EQ(shear.at(-g).stress, -shear.at(g).stress);
    EXPECT_EQ(shear.at(-g).energy, shear.at(g).energy);
  }
}

TEST(SmallestTangent, SeesAFabricThatYields) {
  EXPECT_LT(StressCurve::tension({{0.1, 50}, {0.4, 60}, {1.0, 61}}).smallest_tangent(), 0);
  EXPECT_DOUBLE_EQ(StressCurve::linear(100).smallest_tangent(), 100);
}

TEST(MeasuredPoints, ThatDoNotRiseAreRefusedByNumber) {
  EXPECT_EQ(refusal({{0, 0}, {0.1, 5}}), "accepted");
  const std::string falling = refusal({{0.1, 5}, {0.2, 9}, {0.3, 8.5}});
  EXPECT_NE(falling.find("point 3: found force 8.5 N/m at strain 0.3 after force 9 N/m at strain "
                         "0.2, expected a force that rises"),
            std::string::npos)
      << falling;
  EXPECT_NE(refusal({{0.2, 5}, {0.1, 9}}).find("a strain that rises"), std::string::npos);
  EXPECT_NE(refusal({{0.1, 0}, {0.2, 9}}).find("a force that rises"), std::string::npos);
  EXPECT_NE(refusal({{0.1, NAN}}).find("finite"), std::string::npos);
  EXPECT_NE(refusal({}).find("at least one"), std::string::npos);
  EXPECT_NE(refusal({{0, 0}}).find("at least one"), std::string::npos);
}

}  // namespace
}  // namespace loosefit::fabric

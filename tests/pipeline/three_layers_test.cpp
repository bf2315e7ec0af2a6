#include <gtest/gtest.h>

#include <algorithm>

#include "support/only_draped.h"

// A hoodie over a T-shirt that hangs over trousers: a layer has to lie near the skin where nothing
// is under it, else the hood is sewn round a head as thick as trouser legs stand off.
namespace loosefit::pipeline {
namespace {

TEST(ThreeLayers, HoodieOverATShirtOverTrousersSettlesWithoutArmsSpreadWide) {
  const CaseResult result = support::only_draped(
      "[body]\nsex = \"male\"\nage = 35\nheight = 1.78\n[garment]\npattern = \"hoodie\"\n"
      "[material]\nname = \"wool\"\n[[under]]\npattern = \"trousers\"\n[under.material]\nname = "
      "\"wool\"\n[[under]]\npattern = \"t-shirt\"\n[under.material]\nname = \"cotton-jersey\"\n"
      "[simulation]\nedge_length = 0.04\n[donning]\nmovements = []\n");
  ASSERT_EQ(result.garments.size(), 3u);
  EXPECT_EQ(result.certificate().intersections_layers, 0);
  EXPECT_FALSE(result.studied().drape.report.was_tried(drape::RecoveryKind::wide_posture));
  // The T-shirt's hem hangs outside the waistband, below it.
  const auto height = [&](int garment, auto of) {
    double z = result.garments[garment].drape.positions[0].z();
    for (const Vec3& p : result.garments[garment].drape.positions) z = of(z, p.z());
    return z;
  };
  const double hem = height(1, [](double a, double b) { return std::min(a, b); });
  const double waist = height(0, [](double a, double b) { return std::max(a, b); });
  EXPECT_LT(hem, waist - 0.05);
}

}  // namespace
}  // namespace loosefit::pipeline

#include <gtest/gtest.h>

#include "loosefit/drape/drape_session.h"
#include "loosefit/garment/hierarchy.h"
#include "support/sewn_garments.h"
#include "support/shirt_on_body.h"

namespace loosefit::drape {
namespace {

/// A tube of two panels, so many times as wide as the hips, to the thighs.
Drape draped_tube(double wider, const DrapeOptions& options) {
  static const body::Body body = support::standing(support::adult_parameters(), 40);
  const testing_support::Levels levels = testing_support::levels_of(body);
  const pattern::Pattern pattern =
      testing_support::skirt(levels, wider * levels.hip / levels.waist, wider, 0.45, 2);
  fabric::Material material;
  material.bending_warp = material.bending_weft = 5e-6;
  const garment::GarmentHierarchy garment = garment::build_hierarchy(pattern, 0.04, material);
  Progress silent;
  return drape_garment(
      garment, material, [&](double) { return body; }, options, silent);
}

TEST(Stall, ATubeWiderThanTheHipsSlidesAndIsGivenUpEarlyWithThatReason) {
  int given_up = 0;
  for (const double wider : {1.03, 1.06}) {
    DrapeOptions options;
    options.tuning.stall.iterations = 150;
    const Drape drape = draped_tube(wider, options);
    if (drape.certificate.settled()) continue;  // it may hang on the hips, or lie on the floor
    EXPECT_TRUE(drape.certificate.reason == StopReason::slides_down ||
                drape.certificate.reason == StopReason::no_progress)
        << drape.certificate.stop_reason;
    EXPECT_LT(drape.report.total().iterations, 2000);
    ASSERT_TRUE(drape.unsettled);
    ++given_up;
  }
  EXPECT_GT(given_up, 0);
}

TEST(Stall, ADrapeThatComesToRestIsLetAlone) {
  DrapeOptions options;
  const Drape drape = draped_tube(0.9, options);
  EXPECT_TRUE(drape.certificate.settled()) << drape.certificate.stop_reason;
  options.tuning.stall.iterations = 400;
  const Drape again = draped_tube(0.9, options);
  EXPECT_EQ(drape.positions, again.positions);
}

}  // namespace
}  // namespace loosefit::drape

#include "loosefit/drape/wrapped_leg.h"

#include <gtest/gtest.h>

#include "loosefit/drape/arrange_panels.h"
#include "loosefit/drape/drape_session.h"
#include "loosefit/drape/phases/close_seams.h"
#include "loosefit/drape/worn.h"
#include "loosefit/garment/assemble.h"
#include "support/body_fixture.h"
#include "support/shirt_on_body.h"
#include "support/unsewn_garments.h"
#include "support/worn_and_settled.h"

namespace loosefit::drape {
namespace {

using testing_support::from_nothing;
using testing_support::unsewn_leggings;
using testing_support::upright_strip;

const body::PosedBody& woman() {
  static const body::PosedBody body = support::standing(support::adult_parameters(), 40);
  return body;
}

pattern::Pattern leggings(bool waistband) {
  const auto& m = woman()->measured;
  pattern::Pattern pattern = unsewn_leggings(1.05 * m.at("waist"), 1.04 * m.at("hip"),
                                             m.at("waist_level") - m.at("crotch_height") + 0.01,
                                             m.at("crotch_height") - 0.12, 0.30);
  if (waistband) pattern.panels.push_back(upright_strip("waistband", 1.0 * m.at("waist"), 0.04));
  return from_nothing(pattern);
}

TEST(WrapLeg, ALegInOnePieceLiesRoundTheOutsideOfItsLegAndCloses) {
  const pattern::Pattern pattern = leggings(false);
  const garment::Garment sewn = garment::assemble(pattern, 0.025, fabric::Material{});
  const garment::OpenSeams open = garment::open_seams(sewn);
  const ArrangedPanels panels = arrange_panels(sewn, open, pattern, woman());
  double left_most = 0, front = 0, back = 0;
  for (int v = 0; v < open.garment.vertex_count; ++v) {
    EXPECT_GT(woman().tree().signed_distance(panels.x[v]), 0.005) << v;
    const bool left = open.garment.panel_names[open.garment.vertex_panel[v]] == "leg";
    EXPECT_GT((left ? 1 : -1) * panels.x[v].x(), -0.005) << v;
    left_most = std::max(left_most, panels.x[v].x());
    front = std::min(front, panels.x[v].y()), back = std::max(back, panels.x[v].y());
  }
  EXPECT_LT(front, -0.08);
  EXPECT_GT(back, 0.08);
  EXPECT_GT(left_most, 0.15);
  const ClosedSeams closed = close_seams(sewn, open, panels, woman(), 3);
  EXPECT_EQ(closed.cuts, 0);
  EXPECT_FALSE(closed.in_limb);
  EXPECT_LT(closed.gap, 0.01);
}

TEST(WrapLeg, LeggingsWithAndWithoutAWaistbandAreWornAndSettled) {
  for (const bool waistband : {false, true}) {
    SCOPED_TRACE(waistband);
    const pattern::Pattern pattern = leggings(waistband);
    testing_support::expect_worn_and_settled(pattern, 0.025, woman());
  }
}

}  // namespace
}  // namespace loosefit::drape

#include "loosefit/kinds/tank_top/tank_top.h"

#include <gtest/gtest.h>

#include "loosefit/base/error.h"
#include "loosefit/dress/lay_round.h"
#include "loosefit/garment/assemble.h"
#include "loosefit/geometry/exact_intersection.h"
#include "loosefit/kinds/body_measures.h"
#include "loosefit/pattern/outline.h"
#include "support/shirt_on_body.h"

namespace loosefit {
namespace {

BodyParameters man_parameters() {
  BodyParameters p;
  p.sex = 1;
  return p;
}

std::vector<BodyParameters> people() {
  return {support::adult_parameters(), man_parameters(), support::slim_child_parameters()};
}

DraftedGarment drafted(const Body& body, const NamedValues& fit = {}) {
  const GarmentKind kind = tank_top();
  return kind.draft({draft_measures(kind, body.measured), "", fit, {}});
}

double length_of(const Pattern& pattern, int panel, const std::string& edge) {
  return EdgePath(pattern.panels[panel], find_edge(pattern.panels[panel], edge)).length();
}

TEST(TankTop, HasStrapsOfTheAskedWidthAndSeamsThatClose) {
  for (const BodyParameters& person : people()) {
    const Body body = support::standing(person, 40);
    const auto of = [&](const char* name) { return body.measured.at(name); };
    const double shoulder =
        (of("shoulder_breadth") / 2 - of("neck") / 5) / std::cos(of("shoulder_slope"));
    for (const double width : {0.3, 0.45}) {
      const Pattern tank = drafted(body, {{"strap_width", width}}).pattern;
      ASSERT_EQ(tank.panels.size(), 2u);
      EXPECT_NEAR(length_of(tank, 0, "shoulder_L"), width * shoulder, 1e-9);
      for (const Stitch& s : tank.stitches)
        EXPECT_NEAR(EdgePath(tank.panels[s.first.panel], s.first.edge).length(),
                    EdgePath(tank.panels[s.second.panel], s.second.edge).length(), 1e-12)
            << s.name;
    }
  }
}

TEST(TankTop, NecklineIsDeeperInFrontAndDeepensWithItsKey) {
  const Body body = support::standing(support::adult_parameters(), 40);
  const Pattern usual = drafted(body).pattern, deep = drafted(body, {{"neck_drop", 0.8}}).pattern;
  EXPECT_GT(length_of(usual, 0, "neck"), 1.2 * length_of(usual, 1, "neck"));
  EXPECT_GT(length_of(deep, 0, "neck"), length_of(usual, 0, "neck") + 0.03);
  EXPECT_EQ(length_of(deep, 1, "neck"), length_of(usual, 1, "neck"));
}

TEST(TankTop, IsLaidRoundEverybodyWithoutCuttingItself) {
  for (const BodyParameters& person : people())
    for (const double edge : {0.02, 0.03}) {
      const Body body = support::standing(person, 40);
      const Garment tank = assemble(drafted(body).pattern, edge, Material{});
      const auto x = lay_round(tank, body, tank_top().lay);
      EXPECT_TRUE(self_intersections(x, tank.triangles).empty());
      for (const Triangle& t : tank.triangles)
        EXPECT_GT(triangle_normal(x[t[0]], x[t[1]], x[t[2]]).norm(), 0);
    }
}

TEST(TankTop, GivesAShortBodyALongerHemUnlessThatWasAskedFor) {
  const GarmentKind kind = tank_top();
  NamedValues measures = kind.sizes.front().measures;
  measures["hps_to_hem"] = 0.2;
  const DraftedGarment longer = kind.draft({measures, "", {}, {"measures.hps_to_hem"}});
  ASSERT_EQ(longer.notes.size(), 1u);
  EXPECT_NE(longer.notes[0].find("measures.hps_to_hem"), std::string::npos);
  try {
    kind.draft({measures, "", {}, {}});
    FAIL();
  } catch (const InvalidInput& error) {
    EXPECT_EQ(error.place().key, "measures.hps_to_hem");
  }
  measures.erase("neck");
  EXPECT_THROW(kind.draft({measures, "", {}, {}}), InvalidInput);
  EXPECT_THROW(kind.draft({{}, "women-38", {{"strap_width", 2.0}}, {}}), InvalidInput);
}

}  // namespace
}  // namespace loosefit

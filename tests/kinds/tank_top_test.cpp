#include "loosefit/kinds/tank_top/tank_top.h"

#include <gtest/gtest.h>

#include "loosefit/base/error.h"
#include "loosefit/dress/lay_round.h"
#include "loosefit/garment/assemble.h"
#include "loosefit/geometry/exact_intersection.h"
#include "loosefit/kinds/body_measures.h"
#include "loosefit/pattern/outline.h"
#include "support/shirt_on_body.h"

namespace loosefit::kinds {
namespace {

body::BodyParameters man_parameters() {
  body::BodyParameters p;
  p.sex = 1;
  return p;
}

std::vector<body::BodyParameters> people() {
  return {support::adult_parameters(), man_parameters(), support::slim_child_parameters()};
}

DraftedGarment drafted(const body::Body& body, const NamedValues& fit = {}) {
  const GarmentKind kind = tank_top();
  return kind.draft({draft_measures(kind, body.measured), "", fit, {}});
}

double length_of(const pattern::Pattern& pattern, int panel, const std::string& edge) {
  return pattern::EdgePath(pattern.panels[panel], pattern::find_edge(pattern.panels[panel], edge))
      .length();
}

TEST(TankTop, HasStrapsOfTheAskedWidthAndSeamsThatClose) {
  for (const body::BodyParameters& person : people()) {
    const body::Body body = support::standing(person, 40);
    const auto of = [&](const char* name) { return body.measured.at(name); };
    const double shoulder =
        (of("shoulder_breadth") / 2 - of("neck") / 5) / std::cos(of("shoulder_slope"));
    for (const double width : {0.3, 0.45}) {
      const pattern::Pattern tank = drafted(body, {{"strap_width", width}}).pattern;
      ASSERT_EQ(tank.panels.size(), 2u);
      EXPECT_NEAR(length_of(tank, 0, "shoulder_L"), width * shoulder, 1e-9);
      for (const pattern::Stitch& s : tank.stitches)
        EXPECT_NEAR(pattern::EdgePath(tank.panels[s.first.panel], s.first.edge).length(),
                    pattern::EdgePath(tank.panels[s.second.panel], s.second.edge).length(), 1e-12)
            << s.name;
    }
  }
}

TEST(TankTop, NecklineIsDeeperInFrontAndDeepensWithItsKey) {
  const body::Body body = support::standing(support::adult_parameters(), 40);
  const pattern::Pattern usual = drafted(body).pattern,
                         deep = drafted(body, {{"neck_drop", 0.8}}).pattern;
  EXPECT_GT(length_of(usual, 0, "neck"), 1.2 * length_of(usual, 1, "neck"));
  EXPECT_GT(length_of(deep, 0, "neck"), length_of(usual, 0, "neck") + 0.03);
  EXPECT_EQ(length_of(deep, 1, "neck"), length_of(usual, 1, "neck"));
}

TEST(TankTop, IsLaidRoundEverybodyWithoutCuttingItself) {
  for (const body::BodyParameters& person : people())
    for (const double edge : {0.02, 0.03}) {
      const body::Body body = support::standing(person, 40);
      const garment::Garment tank =
          garment::assemble(drafted(body).pattern, edge, fabric::Material{});
      const auto x = dress::lay_round(tank, body, tank_top().lay);
      EXPECT_TRUE(geometry::self_intersections(x, tank.triangles).empty());
      for (const Triangle& t : tank.triangles)
        EXPECT_GT(geometry::triangle_normal(x[t[0]], x[t[1]], x[t[2]]).norm(), 0);
    }
}

TEST(TankTop, StrapsGiveWayToATightChestUnlessTheyWereAskedFor) {
  const GarmentKind kind = tank_top();
  for (const body::BodyParameters& person : people()) {
    const NamedValues measures = draft_measures(kind, support::standing(person, 40).measured);
    for (const double chest : {-0.35, -0.2, -0.1}) {
      NamedValues fit{{"chest", chest}, {"strap_place", 1}, {"strap_width", 0.45}};
      const DraftedGarment narrow =
          kind.draft({measures, "", fit, {"fit.strap_place", "fit.strap_width"}});
      const double x_underarm = (1 + chest) * measures.at("chest") / 4;
      const pattern::Panel& front = narrow.pattern.panels[0];
      double outer = 0;
      for (const Vec2& v : front.vertices)
        if (v.y() > -0.05) outer = std::max(outer, v.x());
      EXPECT_LT(outer, x_underarm) << "the armhole curves outwards";
      EXPECT_GT(length_of(narrow.pattern, 0, "shoulder_L"), 0.01);
      EXPECT_EQ(narrow.notes.empty(), narrow.fit.at("strap_place") == 1);
      if (narrow.notes.empty()) continue;
      try {
        kind.draft({measures, "", fit, {}});
        ADD_FAILURE() << "straps beside the underarm";
      } catch (const InvalidInput& error) {
        EXPECT_TRUE(error.place().key == "fit.strap_place" ||
                    error.place().key == "fit.strap_width")
            << error.place().key;
      }
    }
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
}  // namespace loosefit::kinds

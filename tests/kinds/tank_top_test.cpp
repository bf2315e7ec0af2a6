#include "loosefit/kinds/tank_top/tank_top.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

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

body::BodyParameters stout_man_parameters() {
  body::BodyParameters p = man_parameters();
  p.age = 55;
  p.weight = 0.95;
  p.muscle = 0.3;
  return p;
}

/// Ends of an edge, the upper one first.
std::pair<Vec2, Vec2> ends_of(const pattern::Pattern& pattern, int panel, const std::string& edge) {
  const pattern::EdgePath path(pattern.panels[panel],
                               pattern::find_edge(pattern.panels[panel], edge));
  return path.at(0).y() > path.at(1).y() ? std::pair(path.at(0), path.at(1))
                                         : std::pair(path.at(1), path.at(0));
}

/// Garment girth / body girth − 1 of the pieces at a level of the shirt's fits.
double level(const DraftedGarment& made, const std::string& name) {
  for (const FitLevel& l : tank_top().levels(made.pattern, made.measures, made.fit))
    if (l.name == name && l.body) return l.garment / *l.body - 1;
  return -99;
}

TEST(TankTop, HasStrapsOfTheAskedWidthAndSeamsThatClose) {
  for (const body::BodyParameters& person : people()) {
    const body::Body body = support::standing(person, 40);
    const auto of = [&](const char* name) { return body.measured.at(name); };
    const double shoulder =
        (of("shoulder_breadth") / 2 - of("neck") / 5) / std::cos(of("shoulder_slope"));
    for (const double width : {0.3, 0.45}) {
      const DraftedGarment made =
          drafted(body, {{"strap_width", width}, {"chest", 0.12}, {"hip", 0.2}});
      const pattern::Pattern& tank = made.pattern;
      ASSERT_EQ(tank.panels.size(), 2u);
      EXPECT_NEAR(level(made, "chest"), 0.12, 1e-9);
      EXPECT_NEAR(level(made, "hip"), 0.2, 1e-9);
      for (const int piece : {0, 1}) {
        EXPECT_NEAR(length_of(tank, piece, "shoulder_L"), width * shoulder, 1e-9);
        // The strap begins so far down the shoulder from the side of the neck.
        const double in = of("neck") / 5, along = 0.45 * (1 - width) * shoulder;
        const Vec2 begins = ends_of(tank, piece, "shoulder_L").first;
        EXPECT_NEAR(std::hypot(std::abs(begins.x()) - in, begins.y()), along, 1e-9);
        const auto [underarm, hem] = ends_of(tank, piece, "side_L");
        const double down = std::sin(of("shoulder_slope")) * shoulder + of("scye_depth") + 0.02;
        EXPECT_NEAR(underarm.y(), -down, 1e-9);
        EXPECT_NEAR(hem.y(), -of("hps_to_hip") - 0.5 * of("front_balance"), 1e-9);
      }
      for (const pattern::Stitch& s : tank.stitches)
        EXPECT_NEAR(pattern::EdgePath(tank.panels[s.first.panel], s.first.edge).length(),
                    pattern::EdgePath(tank.panels[s.second.panel], s.second.edge).length(), 1e-12)
            << s.name;
    }
  }
}

// As in the shirt: what a body has before its sides, cloth has too.
TEST(TankTop, FrontIsLongerAndWiderByWhatTheBodyIsAndTheSidesGoRoundABelly) {
  const GarmentKind kind = tank_top();
  NamedValues m = kind.sizes.front().measures;
  for (const auto& [name, value] : {std::pair{"chest", 1.10},
                                    {"waist", 1.20},
                                    {"hip", 1.12},
                                    {"neck", 0.42},
                                    {"shoulder_breadth", 0.46},
                                    {"hps_to_waist", 0.47},
                                    {"hps_to_hem", 0.70}})
    m[name] = value;
  const DraftedGarment flat = kind.draft({m, "", {}, {}});
  m["front_balance"] = 0.045;
  m["front_fullness"] = 0.03;
  const DraftedGarment made = kind.draft({m, "", {}, {}});
  const auto hem_at = [](const DraftedGarment& tank, int piece, double share) {
    const pattern::Panel& panel = tank.pattern.panels[piece];
    return pattern::EdgePath(panel, pattern::find_edge_part(panel, "hem")).at(share).y();
  };
  EXPECT_NEAR(hem_at(made, 0, 0.5), -0.70 - 0.045, 1e-9);
  EXPECT_NEAR(hem_at(made, 1, 0.5), -0.70, 1e-9);
  EXPECT_NEAR(hem_at(flat, 0, 0.5), -0.70, 1e-9);
  // Halfway at the sides, where front and back meet.
  for (const int piece : {0, 1}) EXPECT_NEAR(hem_at(made, piece, 0), -0.70 - 0.0225, 1e-9);
  // Half of the girth and of the fullness before, and the same less behind.
  const auto half_width = [&](int piece) {
    return std::abs(ends_of(made.pattern, piece, "side_L").first.x());
  };
  EXPECT_NEAR(half_width(0), 1.05 * (1.10 / 4 + 0.015), 1e-9);
  EXPECT_NEAR(half_width(1), 1.05 * (1.10 / 4 - 0.015), 1e-9);
  EXPECT_NEAR(level(made, "chest"), 0.05, 1e-9);
  EXPECT_NEAR(level(made, "hip"), 0.06, 1e-9);
  // Between the mobilities of chest and hip at the waist, where a straight side left −3 %.
  EXPECT_GT(level(made, "waist"), 0.0499);
  EXPECT_LT(level(made, "waist"), 0.0601);
  EXPECT_NEAR(level(kind.draft({m, "", {{"waist", 0.2}}, {}}), "waist"), 0.2, 1e-9);
}

TEST(TankTop, AStoutManGetsALongerFrontAndRoomForHisBelly) {
  const body::Body body = support::standing(stout_man_parameters(), 40);
  const double balance = body.measured.at("front_balance");
  ASSERT_GT(balance, 0.01);
  const DraftedGarment made = drafted(body);
  const auto middle_of_hem = [&](int piece) {
    const pattern::Panel& panel = made.pattern.panels[piece];
    return pattern::EdgePath(panel, pattern::find_edge_part(panel, "hem")).at(0.5).y();
  };
  EXPECT_NEAR(middle_of_hem(1) - middle_of_hem(0), balance, 1e-6);
  EXPECT_GT(level(made, "waist"), 0.0499);
}

TEST(TankTop, AFrontBeyondItsRangeIsTakenAtItsEndUnlessItWasAskedFor) {
  const GarmentKind kind = tank_top();
  NamedValues m = kind.sizes.front().measures;
  m["front_balance"] = 0.30;
  const DraftedGarment kept = kind.draft({m, "", {}, {"measures.front_balance"}});
  EXPECT_EQ(kept.measures.at("front_balance"), 0.25);
  ASSERT_EQ(kept.notes.size(), 1u);
  EXPECT_EQ(kept.notes[0].rfind("measures.front_balance: 0.25 instead of 0.3", 0), 0u);
  EXPECT_THROW(kind.draft({m, "", {}, {}}), InvalidInput);
}

/// How much higher the middle of the front's hem lies than its ends [m].
double front_rises(const DraftedGarment& made) {
  double high = -9;
  for (const pattern::PanelEdge& edge : made.pattern.panels[0].edges)
    if (edge.part == "hem")
      for (const Vec2& knot : edge.knots) high = std::max(high, knot.y());
  return high - ends_of(made.pattern, 0, "side_L").second.y();
}

TEST(TankTop, AFrontIsAsMuchShorterAsTheBodyIsWhereTheSidesAreLongEnough) {
  const GarmentKind kind = tank_top();
  NamedValues m = kind.sizes.front().measures;
  m["front_balance"] = -0.08;
  const DraftedGarment made = kind.draft({m, "", {}, {}});
  EXPECT_NEAR(front_rises(made), 0.04, 1e-9);
  EXPECT_EQ(made.measures.at("front_balance"), -0.08);
  EXPECT_TRUE(made.notes.empty());
}

TEST(TankTop, AFrontThatWouldEndAtTheUnderarmIsLongerUnlessItWasAskedFor) {
  const GarmentKind kind = tank_top();
  NamedValues m = kind.sizes.front().measures;
  const auto underarm = [&] {
    return std::tan(m.at("shoulder_slope")) * (m.at("shoulder_breadth") / 2 - m.at("neck") / 5) +
           m.at("scye_depth") + 0.02;
  };
  for (const double side : {0.0604, 0.0733, 0.0867, 0.1001}) {
    SCOPED_TRACE(side);
    m["hps_to_hem"] = underarm() + side;
    m["front_balance"] = -0.08;
    const DraftedGarment made = kind.draft({m, "", {}, {"measures.front_balance"}});
    const double told = made.measures.at("front_balance"), least = 0.03 - side;
    EXPECT_GE(told, least);
    EXPECT_LT(told, least + 0.001);
    EXPECT_NEAR(front_rises(made), -told / 2, 1e-9);
    ASSERT_EQ(made.notes.size(), 1u);
    EXPECT_TRUE(made.notes[0].starts_with(
        fmt::format("measures.front_balance: {:.3g} instead of -0.08, since otherwise ", told)))
        << made.notes[0];
    try {
      kind.draft({m, "", {}, {}});
      ADD_FAILURE() << "a front that ends at the underarm";
    } catch (const InvalidInput& error) {
      EXPECT_EQ(error.place().key, "measures.front_balance");
      const std::string said = error.what();
      ASSERT_NE(said.find("at least "), std::string::npos) << said;
      m["front_balance"] = std::stod(said.substr(said.find("at least ") + 9));
      EXPECT_EQ(m.at("front_balance"), told);
      EXPECT_NEAR(front_rises(kind.draft({m, "", {}, {}})), -told / 2, 1e-9);
    }
  }
}

// What is told to fit into a chest does, as it is written.
TEST(TankTop, StrapsAsWideAsARefusalSaysAreDrafted) {
  const GarmentKind kind = tank_top();
  const NamedValues m = kind.sizes.front().measures;
  int told = 0;
  for (double chest = -0.35; chest < -0.1; chest += 0.0137)
    for (const char* key : {"strap_width", "strap_place"}) {
      // The widest straps lie at the neck.
      NamedValues fit = {{"chest", chest}, {"strap_place", 0}};
      fit[key] = 1;
      const NamedValues wide = fit;
      try {
        kind.draft({m, "", fit, {}});
      } catch (const InvalidInput& error) {
        const std::string said = error.what();
        const std::size_t at = said.find("at most ");
        if (at == std::string::npos || error.place().key != std::string("fit.") + key) continue;
        ++told;
        fit[key] = std::stod(said.substr(at + 8));
        EXPECT_NO_THROW(kind.draft({m, "", fit, {}})) << said;
        EXPECT_EQ(kind.draft({m, "", wide, {std::string("fit.") + key}}).fit.at(key), fit[key]);
      }
    }
  EXPECT_GT(told, 10);
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

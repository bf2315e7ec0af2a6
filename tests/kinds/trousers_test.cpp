#include "loosefit/kinds/trousers/trousers.h"

#include <gtest/gtest.h>

#include "loosefit/base/error.h"
#include "loosefit/dress/lay_round.h"
#include "loosefit/garment/assemble.h"
#include "loosefit/geometry/exact_intersection.h"
#include "loosefit/kinds/body_measures.h"
#include "loosefit/kinds/recognise.h"
#include "loosefit/kinds/trousers/trousers_draft.h"
#include "loosefit/pattern/outline.h"
#include "support/shirt_on_body.h"

namespace loosefit::kinds {
namespace {

/// Plausible people by measures alone.
std::vector<NamedValues> people() {
  return {{{"waist", 0.72},
           {"hip", 0.97},
           {"waist_level", 1.03},
           {"hip_level", 0.85},
           {"crotch_height", 0.79},
           {"thigh", 0.52},
           {"knee", 0.34},
           {"calf", 0.35},
           {"ankle", 0.19}},
          {{"waist", 0.86},
           {"hip", 1.02},
           {"waist_level", 1.10},
           {"hip_level", 0.92},
           {"crotch_height", 0.84}},
          {{"waist", 1.15},
           {"hip", 1.14},
           {"waist_level", 1.06},
           {"hip_level", 0.90},
           {"crotch_height", 0.78}},
          {{"waist", 0.58},
           {"hip", 0.70},
           {"waist_level", 0.82},
           {"hip_level", 0.70},
           {"crotch_height", 0.62}}};
}

DraftedGarment drafted(const GarmentKind& kind, const NamedValues& measures,
                       const NamedValues& fit = {}) {
  return kind.draft({measures, "", fit, {}});
}

double level(const GarmentKind& kind, const DraftedGarment& made, const std::string& name) {
  for (const FitLevel& l : kind.levels(made.pattern, made.measures, made.fit))
    if (l.name == name && l.body) return l.garment / *l.body - 1;
  return -99;
}

double length_of(const pattern::Pattern& p, const pattern::Stitch::Side& side) {
  return pattern::EdgePath(p.panels[side.panel], side.edge).length();
}

TEST(Trousers, HaveTheAskedGirthsAtEveryLevel) {
  for (const GarmentKind& kind : {trousers(), leggings()})
    for (const NamedValues& person : people()) {
      SCOPED_TRACE(kind.name);
      const NamedValues fit = {{"hip", 0.12},  {"thigh", 0.2}, {"knee", 0.3},
                               {"calf", 0.35}, {"hem", 0.8},   {"waistband", -0.1}};
      const DraftedGarment made = drafted(kind, person, fit);
      EXPECT_NEAR(level(kind, made, "waistband"), -0.1, 1e-9);
      EXPECT_NEAR(level(kind, made, "knee"), 0.3, 1e-6);
      EXPECT_NEAR(level(kind, made, "calf"), 0.35, 1e-6);
      EXPECT_NEAR(level(kind, made, "hem"), 0.8, 1e-6);
      EXPECT_NEAR(level(kind, made, "thigh"), 0.2, 1e-6);
      EXPECT_NEAR(level(kind, made, "hip"), 0.12, 1e-6);
    }
}

TEST(Trousers, SeamsAreAsLongAsEachOtherButForTheGatheredWaist) {
  for (const GarmentKind& kind : {trousers(), leggings()})
    for (const NamedValues& person : people()) {
      const pattern::Pattern p = drafted(kind, person).pattern;
      ASSERT_EQ(p.stitches.size(), 12u);
      for (const pattern::Stitch& s : p.stitches) {
        SCOPED_TRACE(s.name);
        const double a = length_of(p, s.first), b = length_of(p, s.second);
        if (s.name.starts_with("waistband_front_") || s.name.starts_with("waistband_back_"))
          EXPECT_GT(a, 0.9 * b);
        else
          EXPECT_NEAR(a, b, 1e-7);
      }
    }
}

TEST(Trousers, TheCrotchSeamIsSmoothWhereTheFourPiecesMeet) {
  const pattern::Pattern p = drafted(trousers(), people()[0]).pattern;
  for (const pattern::Panel& panel : p.panels) {
    const int e = pattern::find_edge_part(panel, "centre");
    if (e < 0) continue;
    const pattern::EdgePath centre(panel, e);
    const bool from_waist = centre.at(0).y() > centre.at(1).y();
    const Vec2 tip = centre.at(from_waist ? 1 : 0), near = centre.at(from_waist ? 0.999 : 0.001);
    EXPECT_NEAR((near - tip).normalized().y(), 0, 0.02) << panel.name;
  }
}

TEST(Trousers, AskedWaistThatNoSeamCanTakeInIsRefusedOrGivesWay) {
  const GarmentKind kind = trousers();
  const NamedValues fit = {{"waist", -0.1}};
  try {
    kind.draft({people()[0], "", fit, {}});
    FAIL() << "a waist of −10 % above this hip";
  } catch (const InvalidInput& error) {
    EXPECT_EQ(error.place().key, "fit.waist");
  }
  const DraftedGarment wide = kind.draft({people()[0], "", fit, {"fit.waist"}});
  EXPECT_EQ(wide.notes.size(), 1u);
  EXPECT_NEAR(wide.fit.at("waist"), least_waist(wide.measures, wide.fit), 1e-12);
  NamedValues impossible = people()[0];
  impossible["waist_level"] = 0.80;
  EXPECT_THROW(kind.draft({impossible, "", {}, {}}), InvalidInput);
  EXPECT_THROW(kind.draft({people()[0], "women-38", {}, {}}), InvalidInput);
}

TEST(Trousers, ShortOnesEndAboveTheKnee) {
  const GarmentKind kind = trousers();
  const DraftedGarment shorts = drafted(kind, people()[0], {{"leg_length", 0.3}});
  double low = 1e9;
  for (const pattern::Panel& panel : shorts.pattern.panels)
    if (!panel.part.starts_with("waistband"))
      for (const Vec2& v : panel.vertices) low = std::min(low, v.y());
  EXPECT_NEAR(low, 0.7 * 0.79, 1e-9);
  EXPECT_NEAR(level(kind, shorts, "hem"), 0.9, 1e-6);
}

TEST(Trousers, AreKnownAgainByTheirSeams) {
  for (const GarmentKind& kind : {trousers(), leggings()})
    for (const double band : {0.035, 0.0}) {
      pattern::Pattern p = drafted(kind, people()[1], {{"waistband_width", band}}).pattern;
      const std::vector<pattern::Panel> before = p.panels;
      for (pattern::Panel& panel : p.panels) {
        panel.name = "piece_" + panel.name.substr(0, 1) + std::to_string(panel.vertices.size());
        panel.part.clear();
        for (pattern::PanelEdge& edge : panel.edges) edge.part.clear();
      }
      ASSERT_TRUE(kind.note_parts(p));
      for (std::size_t i = 0; i < before.size(); ++i) EXPECT_EQ(p.panels[i].part, before[i].part);
    }
}

TEST(Trousers, AreLaidRoundEverybodyWithoutCuttingThemselves) {
  body::BodyParameters man;
  man.sex = 1;
  for (const body::BodyParameters& person :
       {support::adult_parameters(), man, support::slim_child_parameters()})
    for (const double edge : {0.02, 0.03}) {
      const body::Body body = support::standing(person, 40);
      const GarmentKind kind = trousers();
      const garment::Garment made = garment::assemble(
          drafted(kind, draft_measures(kind, body.measured)).pattern, edge, fabric::Material{});
      const auto x = dress::lay_round(made, body, kind.lay);
      EXPECT_TRUE(geometry::self_intersections(x, made.triangles).empty());
    }
}

}  // namespace
}  // namespace loosefit::kinds

#include "loosefit/kinds/shirt/back_waist.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "loosefit/body/body_fit.h"
#include "loosefit/garment/assemble.h"
#include "loosefit/geometry/exact_intersection.h"
#include "loosefit/kinds/body_measures.h"
#include "loosefit/kinds/fit_stations.h"
#include "loosefit/kinds/recognise.h"
#include "loosefit/kinds/shirt/shirt_draft.h"
#include "loosefit/kinds/shirt/shirt_levels.h"
#include "loosefit/kinds/shirt/shirt_refusal.h"
#include "loosefit/pattern/outline.h"
#include "loosefit/pattern/panel_mesh.h"
#include "loosefit/pattern/self_crossing.h"
#include "support/body_fixture.h"
#include "support/shirt_kind.h"

namespace loosefit::kinds {
namespace {

ShirtFit shaped(double back_waist, std::optional<double> waist = {}) {
  ShirtFit fit = usual_shirt_fit();
  fit.back_waist = back_waist;
  fit.waist = waist;
  return fit;
}

ShirtMeasures curved_body() {
  ShirtMeasures m;
  m.front_fullness = m.front_balance = 0.020;
  m.bust_balance = 0.030;
  return m;
}

const pattern::Panel& back_of(const pattern::Pattern& shirt) {
  return shirt.panels[shirt.find_part("back")];
}

pattern::EdgePath edge_of(const pattern::Panel& panel, const char* edge) {
  const int e = pattern::find_edge_part(panel, edge);
  EXPECT_GE(e, 0) << edge;
  return pattern::EdgePath(panel, e);
}

NamedValues girths_of(const ShirtMeasures& m, const ShirtFit& fit) {
  return shirt_girths(draft_shirt(m, fit), m.hps_to_waist);
}

TEST(BackWaist, OfLessThanIsSewnLeavesTheDraftAsItIs) {
  const pattern::Pattern without = draft_shirt(curved_body(), shaped(0)),
                         least = draft_shirt(curved_body(), shaped(0.0049));
  ASSERT_EQ(without.stitches.size(), least.stitches.size());
  for (std::size_t p = 0; p < without.panels.size(); ++p)
    EXPECT_EQ(without.panels[p].vertices, least.panels[p].vertices);
  EXPECT_LT(pattern::find_edge_part(back_of(without), "back_dart_L_inner"), 0);
}

TEST(BackWaist, LegsAreEqualAndOutlinesSimple) {
  for (const double intake : {0.005, 0.02, 0.06})
    for (const double bust_dart : {0.0, 0.5})
      for (const std::optional<double> waist : {std::optional<double>(), std::optional(0.15)}) {
        SCOPED_TRACE(testing::Message() << intake << " " << bust_dart << " " << waist.has_value());
        ShirtFit fit = shaped(intake, waist);
        fit.bust_dart = bust_dart;
        const pattern::Pattern shirt = draft_shirt(curved_body(), fit);
        EXPECT_EQ(shirt.stitches.size(), 14u + (bust_dart > 0 ? 4 : 0));
        for (const pattern::Stitch& s : shirt.stitches)
          EXPECT_NEAR((s.name.starts_with("armhole") ? 1 + fit.cap_ease : 1.0) *
                          pattern::EdgePath(shirt.panels[s.first.panel], s.first.edge).length(),
                      pattern::EdgePath(shirt.panels[s.second.panel], s.second.edge).length(), 1e-7)
              << s.name;
        for (const pattern::Panel& panel : shirt.panels) {
          const auto outline = pattern::outline_polygon(panel);
          EXPECT_EQ(pattern::first_self_crossing(outline).first, -1) << panel.name;
          EXPECT_GT(pattern::signed_area(outline), 0) << panel.name;
        }
      }
}

// Upright where it begins and ends: no corner in the sewn hem, no cone at the tip.
TEST(BackWaist, DartsRunUprightIntoHemAndTip) {
  const ShirtMeasures m = curved_body();
  const pattern::Pattern shirt = draft_shirt(m, shaped(0.06));
  const pattern::Panel& back = back_of(shirt);
  // Outside view: the wearer's right lies at x > 0. From hem to tip, and from tip to hem.
  const pattern::EdgePath inner = edge_of(back, "back_dart_R_inner"),
                          outer = edge_of(back, "back_dart_R_outer"), hem = edge_of(back, "hem_R"),
                          middle = edge_of(back, "hem");
  const Vec2 tip = inner.at(1);
  EXPECT_EQ(tip, outer.at(0));
  EXPECT_NEAR((outer.at(1) - inner.at(0)).norm(), 0.006, 1e-9);
  EXPECT_NEAR(outer.at(1).y(), inner.at(0).y(), 1e-9);
  EXPECT_EQ(hem.at(0), outer.at(1));
  EXPECT_EQ(middle.at(1), inner.at(0));
  EXPECT_NEAR(middle.at(0.5).y(), -m.hps_to_hem, 1e-9);
  for (const auto& leg : {inner, outer}) {
    const auto slope = [&](double at) {
      const Vec2 d = leg.at(at + 0.005) - leg.at(at - 0.005);
      return std::abs(d.x() / d.y());
    };
    EXPECT_LT(slope(0.006), 0.015);
    EXPECT_LT(slope(0.994), 0.015);
    for (double at = 0.01; at < 0.99; at += 0.01) EXPECT_LT(slope(at), 0.2) << at;
  }
  for (const double at : {0.1, 0.4, 0.8}) {
    EXPECT_NEAR(outer.at(1 - at).x() - tip.x(), tip.x() - inner.at(at).x(), 1e-6);
    EXPECT_NEAR(outer.at(1 - at).y(), inner.at(at).y(), 1e-6);
  }
  // Closed, the hem goes on without a corner.
  const Vec2 beyond = hem.at(0.02) - hem.at(0), before = middle.at(1) - middle.at(0.99);
  EXPECT_NEAR(beyond.y() / beyond.x(), before.y() / before.x(), 0.01);
  const double underarm = edge_of(back, "side_R").at(1).y();
  EXPECT_NEAR(underarm - tip.y(), kBackTipDrop, 1e-12);
  // Below the shoulder blade.
  EXPECT_GT(tip.x(), 0.07);
  EXPECT_LT(tip.x(), 0.12);
}

TEST(BackWaist, TakesTheIntakeOutOfTheWaistAndLeavesChestAndHem) {
  const ShirtMeasures m = curved_body();
  const NamedValues without = girths_of(m, shaped(0));
  for (const double intake : {0.01, 0.03, 0.06}) {
    const NamedValues with = girths_of(m, shaped(intake));
    EXPECT_NEAR(without.at("waist") - with.at("waist"), intake, 1e-6);
    EXPECT_NEAR(with.at("chest"), without.at("chest"), 1e-12);
    EXPECT_NEAR(with.at("hip"), without.at("hip"), 1e-12);
  }
}

TEST(BackWaist, StationsTellWhatItTakesInAlongTheTrunk) {
  const ShirtMeasures m = curved_body();
  const ShirtFit plain = shaped(0), fit = shaped(0.03);
  const auto with = shirt_stations(draft_shirt(m, fit), named(m), named(fit)),
             without = shirt_stations(draft_shirt(m, plain), named(m), named(plain));
  ASSERT_EQ(with.size(), without.size());
  const double tip = m.shoulder_length * std::sin(m.shoulder_slope) + m.scye_depth + 0.10;
  double most = 0, most_along = 0;
  int counted = 0;
  for (std::size_t i = 0; i < with.size(); ++i) {
    if (with[i].limb != "trunk") continue;
    const double taken = without[i].garment - with[i].garment;
    EXPECT_GT(taken, -0.0085) << with[i].along;  // what the sides give back for the hem
    EXPECT_LT(taken, 0.0301) << with[i].along;
    if (taken > most) most = taken, most_along = with[i].along;
    if (with[i].along > tip && with[i].along < m.hps_to_hem - 0.05) {
      EXPECT_GT(taken, 0.003) << with[i].along;
      ++counted;
    }
  }
  EXPECT_GT(counted, 8);
  EXPECT_GT(most, 0.028);
  EXPECT_NEAR(most_along, m.hps_to_waist, 0.021);
}

TEST(BackWaist, AnAskedWaistIsThatOfTheSewnShirt) {
  const ShirtMeasures m = curved_body();
  const NamedValues girths = girths_of(m, shaped(0.03, 0.12));
  EXPECT_NEAR(girths.at("waist") / m.waist - 1, 0.12, 1e-6);
  EXPECT_NEAR(girths.at("hip") / m.hip - 1, usual_shirt_fit().hip, 1e-12);
}

// Nobody's waist gets less ease than that between chest and hip, also where it bulges.
TEST(BackWaist, ABellyKeepsItsEase) {
  ShirtMeasures m;
  const ShirtFit plain = shaped(0);
  for (const double waist : {0.90, 0.93, 0.96, 1.02}) {
    m.waist = waist;
    const double before = girths_of(m, plain).at("waist") / waist - 1,
                 after = girths_of(m, shaped(0.06)).at("waist") / waist - 1;
    EXPECT_LE(after, before + 1e-4) << waist;
    EXPECT_GT(after, std::min(plain.chest, plain.hip) - 1e-4) << waist;
  }
}

TEST(BackWaist, IsRefusedOutOfRangeAndWhereItHasNoRoom) {
  const auto refusal = [](const ShirtMeasures& m, const ShirtFit& fit) {
    try {
      draft_shirt(m, fit);
    } catch (const ShirtRefusal& e) {
      return e.place().key;
    }
    return std::string();
  };
  const ShirtMeasures m;
  for (const double out : {-0.001, 0.0601, std::nan("")})
    EXPECT_EQ(refusal(m, shaped(out)), "fit.back_waist") << out;
  ShirtMeasures cropped = m, high = m;
  cropped.hps_to_hem = m.hps_to_waist + 0.04;
  EXPECT_EQ(refusal(cropped, shaped(0)), "");
  EXPECT_EQ(refusal(cropped, shaped(0.02)), "measures.hps_to_waist");
  high.hps_to_waist = 0.27;
  EXPECT_EQ(refusal(high, shaped(0)), "");
  EXPECT_EQ(refusal(high, shaped(0.02)), "measures.hps_to_waist");
}

TEST(BackWaist, IsRecognisedByHowItIsSewn) {
  for (const double bust_dart : {0.0, 1.0}) {
    ShirtFit fit = shaped(0.02);
    fit.bust_dart = bust_dart;
    fit.neckband = bust_dart * 0.02;
    pattern::Pattern shirt = draft_shirt(curved_body(), fit);
    const pattern::Pattern drafted = shirt;
    EXPECT_EQ(draft_mark(shirt), "shirt 1");
    for (pattern::Panel& panel : shirt.panels) {
      panel.name += " renamed", panel.part.clear();
      for (pattern::PanelEdge& edge : panel.edges) edge.name += "?", edge.part.clear();
    }
    ASSERT_EQ(recognise_kind(shirt, "shirt 1"), Recognised::yes) << bust_dart;
    for (std::size_t p = 0; p < shirt.panels.size(); ++p)
      for (std::size_t e = 0; e < shirt.panels[p].edges.size(); ++e)
        EXPECT_EQ(shirt.panels[p].edges[e].part, drafted.panels[p].edges[e].part);
  }
}

TEST(BackWaist, HemsAreFinishedAndDartsAreNot) {
  ShirtFit fit = shaped(0.03);
  fit.edge_finish = 0.02;
  const pattern::Pattern shirt = draft_shirt(curved_body(), fit);
  for (const pattern::PanelEdge& edge : back_of(shirt).edges)
    EXPECT_EQ(edge.finish, edge.part.starts_with("hem") || edge.part == "neck" ? 0.02 : 0.0)
        << edge.part;
}

TEST(BackWaist, IsLaidRoundTheBodyAsOneSurfaceWithoutSlivers) {
  body::BodySpec spec;
  spec.sex = 0, spec.age = 30, spec.height = 1.68;
  spec.measurements = {{"chest", 0.88}};
  const body::Body body = body_model().build(
      body::fit_body(body_model(), spec, body::BodyDetail::coarse).parameters, {radians(45), 0, 0});
  const GarmentKind& kind = garment_kind("long-sleeve-shirt");
  for (const double intake : {0.005, 0.03, 0.06})
    for (const double bust_dart : {0.0, 0.5})
      for (const double edge : {0.036, 0.02}) {
        SCOPED_TRACE(testing::Message() << intake << " " << bust_dart << " " << edge);
        ShirtFit fit = shaped(intake);
        fit.bust_dart = bust_dart;
        DraftRequest request;
        request.measures = draft_measures(kind, body.measured);
        request.fit = named(fit);
        const pattern::Pattern shirt = kind.draft(request).pattern;
        ASSERT_GE(pattern::find_edge_part(back_of(shirt), "back_dart_L_inner"), 0);
        const garment::Garment g = garment::assemble(shirt, edge, fabric::Material{});
        double least = kPi;
        for (const auto& uv : g.triangle_uv)
          least = std::min(least, pattern::smallest_angle(uv[0], uv[1], uv[2]));
        EXPECT_GT(degrees(least), 12);
        const std::vector<Vec3> x = support::dress_shirt(g, body);
        EXPECT_TRUE(geometry::self_intersections(x, g.triangles).empty());
      }
}

}  // namespace
}  // namespace loosefit::kinds

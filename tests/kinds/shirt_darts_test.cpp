#include <gtest/gtest.h>

#include <cmath>

#include "loosefit/body/body_fit.h"
#include "loosefit/garment/assemble.h"
#include "loosefit/geometry/exact_intersection.h"
#include "loosefit/kinds/body_measures.h"
#include "loosefit/kinds/fit_stations.h"
#include "loosefit/kinds/recognise.h"
#include "loosefit/kinds/shirt/bust_dart.h"
#include "loosefit/kinds/shirt/elbow_dart.h"
#include "loosefit/kinds/shirt/shirt_draft.h"
#include "loosefit/kinds/shirt/shirt_levels.h"
#include "loosefit/pattern/outline.h"
#include "loosefit/pattern/panel_mesh.h"
#include "loosefit/pattern/self_crossing.h"
#include "support/body_fixture.h"
#include "support/shirt_kind.h"

namespace loosefit::kinds {
namespace {

ShirtMeasures full_bust() {
  ShirtMeasures m;
  m.chest = 1.0;
  m.bust_balance = m.front_balance = 0.030;
  m.front_fullness = 0.02;
  return m;
}

ShirtFit fit_with(double bust_dart, double elbow_bend) {
  ShirtFit fit = usual_shirt_fit();
  fit.bust_dart = bust_dart;
  fit.elbow_bend = elbow_bend;
  return fit;
}

const pattern::Panel& piece(const pattern::Pattern& shirt, const char* part) {
  return shirt.panels[shirt.find_part(part)];
}

pattern::EdgePath path(const pattern::Panel& panel, const char* edge) {
  const int e = pattern::find_edge_part(panel, edge);
  EXPECT_GE(e, 0) << edge;
  return pattern::EdgePath(panel, e);
}

double seam_difference(const pattern::Pattern& shirt, const pattern::Stitch& s) {
  const double ease = s.name.starts_with("armhole") ? usual_shirt_fit().cap_ease : 0;
  return (1 + ease) * pattern::EdgePath(shirt.panels[s.first.panel], s.first.edge).length() -
         pattern::EdgePath(shirt.panels[s.second.panel], s.second.edge).length();
}

TEST(ShirtDarts, SeamsAndLegsAreEqualAndOutlinesSimple) {
  for (const double bust_dart : {0.0, 0.6, 1.0})
    for (const double bend : {0.0, 15.0, 30.0})
      for (const std::optional<double> waist : {std::optional<double>(), std::optional(0.15)}) {
        SCOPED_TRACE(testing::Message() << bust_dart << " " << bend << " " << waist.has_value());
        ShirtFit fit = fit_with(bust_dart, bend);
        fit.waist = waist;
        const pattern::Pattern shirt = draft_shirt(full_bust(), fit);
        EXPECT_EQ(shirt.stitches.size(), 12u + (bust_dart > 0 ? 4 : 0) + (bend > 0 ? 4 : 0));
        for (const pattern::Stitch& s : shirt.stitches)
          EXPECT_NEAR(seam_difference(shirt, s), 0, 1e-7) << s.name;
        for (const pattern::Panel& panel : shirt.panels) {
          const auto outline = pattern::outline_polygon(panel);
          EXPECT_EQ(pattern::first_self_crossing(outline).first, -1) << panel.name;
          EXPECT_GT(pattern::signed_area(outline), 0) << panel.name;
        }
      }
}

TEST(BustDart, TakesUpTheShareOfTheBustBalanceAndPointsAtTheBust) {
  const ShirtMeasures m = full_bust();
  for (const double share : {0.5, 1.0}) {
    const pattern::Pattern shirt = draft_shirt(m, fit_with(share, 0));
    const pattern::Panel& front = piece(shirt, "front");
    const Vec2 tip = path(front, "dart_L_below").at(1), above = path(front, "side_L").at(0),
               below = path(front, "side_L_below").at(1);
    // Chord of the turn about the tip.
    const double leg = (above - tip).norm(), intake = share * m.bust_balance;
    EXPECT_NEAR((above - below).norm(), intake, 1e-9);
    EXPECT_NEAR(std::acos((above - tip).dot(below - tip) / (leg * leg)),
                2 * std::asin(0.5 * intake / leg), 1e-7);
    // The line from the middle of the mouth over the tip goes to the bust point, 25 mm on.
    const Vec2 bust(0.5 * m.bust_span, -m.hps_to_bust);
    EXPECT_NEAR((tip - bust).norm(), 0.025, 1e-9);
    const Vec2 from = above - Vec2(0, 0.5 * intake) - bust, to = tip - bust;
    EXPECT_NEAR(from.x() * to.y() - from.y() * to.x(), 0, 1e-12);
    // Both sides are mirror images.
    const Vec2 other = path(front, "dart_R_below").at(0);
    EXPECT_NEAR(other.x(), -tip.x(), 1e-12);
    EXPECT_NEAR(other.y(), tip.y(), 1e-12);
  }
}

TEST(BustDart, HemHasTheIntakeAtItsSidesAndTheRestOfTheBalanceInItsMiddle) {
  ShirtMeasures m = full_bust();
  m.front_balance = 0.020;
  for (const double share : {0.5, 1.0}) {
    const pattern::Pattern shirt = draft_shirt(m, fit_with(share, 0));
    const auto front = path(piece(shirt, "front"), "hem"), back = path(piece(shirt, "back"), "hem");
    const double intake = share * m.bust_balance;
    EXPECT_NEAR(back.at(0).y() - front.at(0).y(), intake, 1e-3);
    EXPECT_NEAR(back.at(0.5).y() - front.at(0.5).y(), intake + (1 - share) * 0.020, 1e-9);
  }
}

TEST(BustDart, LeavesGirthsAsAsked) {
  const ShirtMeasures m = full_bust();
  ShirtFit fit = fit_with(1, 0);
  fit.waist = 0.2;
  const pattern::Pattern shirt = draft_shirt(m, fit);
  const NamedValues girths = shirt_girths(shirt, m.hps_to_waist);
  EXPECT_NEAR(girths.at("chest") / m.chest - 1, fit.chest, 1e-12);
  EXPECT_NEAR(girths.at("waist") / m.waist - 1, *fit.waist, 1e-3);
  EXPECT_NEAR(girths.at("hip") / m.hip - 1, fit.hip, 1e-12);
  // All along the trunk as without a dart, within what the turn of its mouth takes in.
  fit.bust_dart = 0;
  const auto with = shirt_stations(shirt, named(m), named(fit)),
             without = shirt_stations(draft_shirt(m, fit), named(m), named(fit));
  ASSERT_EQ(with.size(), without.size());
  for (std::size_t i = 0; i < with.size(); ++i)
    EXPECT_NEAR(with[i].garment / without[i].garment, 1, 0.02) << with[i].along;
}

TEST(BustDart, IsLeftOutWhereTheBodyNeedsNone) {
  ShirtMeasures flat;
  const ShirtFit fit = fit_with(1, 0);
  for (const double balance : {-0.02, 0.0, 0.0119}) {
    flat.bust_balance = balance;
    EXPECT_EQ(bust_dart_intake(flat, fit), 0) << balance;
    EXPECT_EQ(draft_shirt(flat, fit).stitches.size(), 12u) << balance;
  }
  flat.bust_balance = 0.0121;
  EXPECT_EQ(draft_shirt(flat, fit).stitches.size(), 16u);
}

body::Body person(double sex, double age, double height, double chest, double arms = 25) {
  body::BodySpec spec;
  spec.sex = sex, spec.age = age, spec.height = height;
  spec.measurements = {{"chest", chest}};
  const body::BodyFit fit = body::fit_body(body_model(), spec, body::BodyDetail::coarse);
  return body_model().build(fit.parameters, {radians(arms), 0, 0});
}

TEST(BustDart, OfAChildAndAManIsNoSliver) {
  const auto intake = [](const body::Body& body) {
    const auto measures = known_measures(garment_kind("long-sleeve-shirt"), body.measured);
    return bust_dart_intake(shirt_measures_of(measures), fit_with(0.5, 0));
  };
  EXPECT_EQ(intake(person(0.4, 10, 1.40, 0.70)), 0);
  EXPECT_EQ(intake(person(0, 10, 1.40, 0.70)), 0);
  EXPECT_EQ(intake(person(1, 35, 1.78, 0.98)), 0);
  EXPECT_GT(intake(person(0, 30, 1.68, 0.88)), 0.015);
  EXPECT_GT(intake(person(0, 30, 1.68, 1.00)), 0.020);
}

// A cut at the joint of two curves leaves no curve without length, elsewhere none without its own.
TEST(ShirtDarts, SeamsAreCutIntoPartsThatMakeUpTheWhole) {
  pattern::CurveChain chain;
  chain.start = Vec2(0, 0);
  chain.line_to({0, -0.3}).cubic_to({0.1, -0.4}, {0.1, -0.5}, {0, -0.6}).line_to({0, -0.8});
  const double joint = 0.3, whole = chain.length();
  for (const double arc :
       {0.1, joint - 1e-9, joint, joint + 1e-9, 0.45, whole - 0.2, whole - 0.1}) {
    const auto [before, after] = chain.cut(arc);
    EXPECT_NEAR(before.length(), arc, 2e-9);
    EXPECT_NEAR(after.length(), whole - arc, 2e-9);
    EXPECT_EQ(before.end(), after.start);
    EXPECT_EQ(after.end(), chain.end());
    EXPECT_EQ(before.curves.size() + after.curves.size(),
              std::abs(arc - joint) < 1e-8 || arc == whole - 0.2 ? 3u : 4u)
        << arc;
  }
}

TEST(ShirtDarts, AreLaidRoundTheBody) {
  const body::Body body = person(0, 30, 1.68, 0.88, 45);
  const GarmentKind& kind = garment_kind("long-sleeve-shirt");
  for (const double bust_dart : {0.5, 1.0})
    for (const double edge : {0.036, 0.028, 0.02}) {
      DraftRequest request;
      request.measures = draft_measures(kind, body.measured);
      request.fit = named(fit_with(bust_dart, 15));
      const pattern::Pattern shirt = kind.draft(request).pattern;
      ASSERT_EQ(shirt.stitches.size(), 20u);
      const garment::Garment g = garment::assemble(shirt, edge, fabric::Material{});
      const std::vector<Vec3> x = support::dress_shirt(g, body);
      EXPECT_TRUE(geometry::self_intersections(x, g.triangles).empty());
    }
}

TEST(ElbowDart, OpensByTheBendTimesTheGirthAndKeepsTheSleevesGirth) {
  const ShirtMeasures m;
  for (const double bend : {10.0, 15.0, 30.0}) {
    const pattern::Pattern shirt = draft_shirt(m, fit_with(0, bend)),
                           straight = draft_shirt(m, fit_with(0, 0));
    const pattern::Panel& back = piece(shirt, "sleeve_L_back");
    const Vec2 above = path(back, "under").at(0), below = path(back, "under_below").at(1);
    const auto dart = path(back, "dart_below");
    // 2 r times the bend, r of the sleeve round the elbow: half of it reaches the middle.
    const auto stations = shirt_stations(straight, named(m), named(fit_with(0, 0)));
    double girth = 0, nearest = 1;
    for (const FitStation& s : stations)
      if (s.limb == "arm" && std::abs(s.along - m.elbow_length) < nearest)
        nearest = std::abs(s.along - m.elbow_length), girth = s.garment;
    EXPECT_NEAR((above - below).norm(), girth / kPi * radians(bend), 2e-3 * bend / 10);
    EXPECT_NEAR((dart.at(0) - dart.at(1)).norm(), (above - dart.at(1)).norm(), 0.02);
    const auto bent = shirt_stations(shirt, named(m), named(fit_with(0, bend)));
    ASSERT_EQ(bent.size(), stations.size());
    for (std::size_t i = 0; i < bent.size(); ++i)
      EXPECT_NEAR(bent[i].garment / stations[i].garment, 1, 0.02) << bent[i].along;
  }
}

TEST(ElbowDart, IsLeftOutOfAShortSleeve) {
  ShirtFit fit = fit_with(0, 20);
  fit.sleeve_length = 0.36;
  EXPECT_EQ(draft_shirt(ShirtMeasures{}, fit).stitches.size(), 12u);
}

TEST(ShirtDarts, AreRecognisedByHowTheyAreSewn) {
  for (const double bust_dart : {0.0, 1.0})
    for (const double bend : {0.0, 15.0}) {
      pattern::Pattern shirt = draft_shirt(full_bust(), fit_with(bust_dart, bend));
      const pattern::Pattern drafted = shirt;
      EXPECT_EQ(draft_mark(shirt), "shirt 1");
      // Names do not matter.
      for (pattern::Panel& panel : shirt.panels) {
        panel.name += " renamed", panel.part.clear();
        for (pattern::PanelEdge& edge : panel.edges) edge.name += "?", edge.part.clear();
      }
      ASSERT_EQ(recognise_kind(shirt, "shirt 1"), Recognised::yes) << bust_dart << " " << bend;
      for (std::size_t p = 0; p < shirt.panels.size(); ++p)
        for (std::size_t e = 0; e < shirt.panels[p].edges.size(); ++e)
          EXPECT_EQ(shirt.panels[p].edges[e].part, drafted.panels[p].edges[e].part);
    }
}

TEST(ShirtDarts, MeshAsOneSurfaceWithoutSlivers) {
  const pattern::Pattern shirt = draft_shirt(full_bust(), fit_with(1, 15));
  for (const double edge : {0.03, 0.014}) {
    const garment::Garment g = garment::assemble(shirt, edge, fabric::Material{});
    double least = kPi;
    for (const auto& uv : g.triangle_uv)
      least = std::min(least, pattern::smallest_angle(uv[0], uv[1], uv[2]));
    EXPECT_GT(degrees(least), 12) << edge;
  }
}

}  // namespace
}  // namespace loosefit::kinds

#include "loosefit/dress/dress_as_placed.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "loosefit/base/error.h"
#include "loosefit/garment/assemble.h"
#include "loosefit/geometry/closest_point_tree.h"
#include "loosefit/geometry/exact_intersection.h"
#include "support/shapes.h"
#include "support/simple_patterns.h"

namespace loosefit::dress {
namespace {

using namespace testing_support;

/// Two squares sewn at both sides into a tube: the front before, the back behind and turned round.
pattern::Pattern two_squares(double distance) {
  pattern::Pattern pattern;
  pattern.panels = {rectangle_panel("front", 0.4, 0.3), rectangle_panel("back", 0.4, 0.3)};
  // Outside (panel z) of the front looks to −y, of the back to +y.
  Mat3 front, back;
  front.col(0) = Vec3::UnitX();
  front.col(1) = Vec3::UnitZ();
  front.col(2) = -Vec3::UnitY();
  back.col(0) = -Vec3::UnitX();
  back.col(1) = Vec3::UnitZ();
  back.col(2) = Vec3::UnitY();
  pattern.panels[0].rotation = front;
  pattern.panels[0].translation = Vec3(-0.2, -distance / 2, 1.0);
  pattern.panels[1].rotation = back;
  pattern.panels[1].translation = Vec3(0.2, distance / 2, 1.0);
  pattern.stitches = {stitch(0, 1, 1, 3), stitch(0, 3, 1, 1)};
  return pattern;
}

body::Body far_away() {
  body::Body ball;
  ball.surface = support::sphere(0.1, 6, 12);
  for (Vec3& p : ball.surface.vertices) p += Vec3(9, 9, 9);
  return ball;
}

TEST(DressAsPlaced, PutsPanelsWhereThePatternSaysAndClosesSeamsInTheMiddle) {
  const pattern::Pattern pattern = two_squares(0.3);
  const garment::Garment g = garment::assemble(pattern, 0.04, fabric::Material{});
  const auto x = dress_as_placed(g, pattern, far_away());
  EXPECT_TRUE(geometry::self_intersections(x, g.triangles).empty());
  for (const auto& chain : g.edge_chains)
    for (int v : chain.vertices)
      if (chain.edge == 1 || chain.edge == 3) {
        EXPECT_NEAR(x[v][1], 0, 1e-12);
        EXPECT_NEAR(std::abs(x[v][0]), 0.2, 1e-12);
      }
  // Panel interiors keep their place and their outside.
  for (std::size_t t = 0; t < g.triangles.size(); ++t) {
    const Triangle& tri = g.triangles[t];
    const bool front = g.panel_names[g.triangle_panel[t]] == "front";
    const Vec3 n = geometry::triangle_normal(x[tri[0]], x[tri[1]], x[tri[2]]);
    EXPECT_GT((front ? -1 : 1) * n[1], 0);
    for (int k = 0; k < 3; ++k) {
      const double u = g.triangle_uv[t][k][0];
      if (u < 1e-9 || u > 0.4 - 1e-9) continue;
      EXPECT_NEAR(x[tri[k]][1], front ? -0.15 : 0.15, 1e-12);
      EXPECT_NEAR(x[tri[k]][2], 1.0 + g.triangle_uv[t][k][1], 1e-12);
    }
  }
}

/// Heights of a panel's inner vertices over where the pattern puts it, along its outside [m].
std::set<long> lifts_in_mm(const garment::Garment& g, const pattern::Pattern& pattern,
                           const std::vector<Vec3>& x, const std::string& name) {
  std::set<long> lifts;
  const pattern::Panel& panel = pattern.panels[pattern.find_panel(name)];
  for (std::size_t t = 0; t < g.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      const double u = g.triangle_uv[t][k][0];
      if (g.panel_names[g.triangle_panel[t]] != name || u < 1e-9 || u > 0.4 - 1e-9) continue;
      const Vec3 local = panel.rotation.transpose() * (x[g.triangles[t][k]] - panel.translation);
      lifts.insert(std::lround(1000 * local[2]));
    }
  return lifts;
}

TEST(DressAsPlaced, PanelsThatCrossArePartedAlongTheirOutsides) {
  pattern::Pattern pattern = two_squares(0.1);
  const garment::Garment g = garment::assemble(pattern, 0.04, fabric::Material{});
  // The back leans, its top edge 0.3 sin 0.4 = 0.117 m from its plane: to one side through the
  // front, to the other away from it.
  std::multiset<bool> moved;
  for (double lean : {-0.4, 0.4}) {
    pattern.panels[1].rotation = two_squares(0.1).panels[1].rotation *
                                 Eigen::AngleAxisd(lean, Vec3::UnitX()).toRotationMatrix();
    const auto x = dress_as_placed(g, pattern, far_away());
    EXPECT_TRUE(geometry::self_intersections(x, g.triangles).empty()) << lean;
    const auto back = lifts_in_mm(g, pattern, x, "back");
    ASSERT_EQ(back.size(), 1u);
    EXPECT_LE(*back.begin(), 50);
    moved.insert(*back.begin() > 0);
  }
  EXPECT_EQ(moved, (std::multiset<bool>{false, true}));
}

TEST(DressAsPlaced, APanelInTheBodyIsMovedOutOfItAndTheOtherStays) {
  pattern::Pattern pattern = two_squares(0.6);
  body::Body ball;
  ball.surface = support::sphere(0.1, 24, 48);
  for (Vec3& p : ball.surface.vertices) p += Vec3(0, 0, 1.15);
  pattern.panels[0].translation[1] = -0.07;  // 3 cm deep in the ball
  const garment::Garment g = garment::assemble(pattern, 0.04, fabric::Material{});
  const auto x = dress_as_placed(g, pattern, ball);
  EXPECT_TRUE(geometry::self_intersections(x, g.triangles).empty());
  const geometry::ClosestPointTree skin(ball.surface);
  for (const Vec3& p : x) EXPECT_GT(skin.signed_distance(p), 0);
  // The vertices at 40 mm from each other may stand 20 mm off the pole, where the ball is 2 mm
  // lower.
  EXPECT_EQ(lifts_in_mm(g, pattern, x, "back"), std::set<long>{0});
  const auto front = lifts_in_mm(g, pattern, x, "front");
  ASSERT_EQ(front.size(), 1u);
  EXPECT_NEAR(static_cast<double>(*front.begin()), 30, 10);
}

TEST(DressAsPlaced, OfTwoPanelsOneOnTheOtherTheLaterIsLaidOver) {
  pattern::Pattern pattern = two_squares(0.3);
  pattern.panels[1] = rectangle_panel("over", 0.4, 0.3);
  pattern.panels[1].rotation = pattern.panels[0].rotation;
  pattern.panels[1].translation = pattern.panels[0].translation + Vec3(0.05, 0, 0.03);
  pattern.stitches.clear();
  const garment::Garment g = garment::assemble(pattern, 0.04, fabric::Material{});
  const auto x = dress_as_placed(g, pattern, far_away());
  EXPECT_TRUE(geometry::self_intersections(x, g.triangles).empty());
  EXPECT_EQ(lifts_in_mm(g, pattern, x, "front"), std::set<long>{0});
  EXPECT_EQ(lifts_in_mm(g, pattern, x, "over"), std::set<long>{10});
}

TEST(DressAsPlaced, PanelsThatCannotBePartedAreNamed) {
  // The back looks the way of the front and is turned a quarter, so that its seams cross the front.
  pattern::Pattern pattern = two_squares(0.1);
  pattern.panels[1].rotation =
      pattern.panels[0].rotation * Eigen::AngleAxisd(kPi / 2, Vec3::UnitZ()).toRotationMatrix();
  pattern.panels[1].translation = Vec3(0.2, -0.05, 1.0);
  const garment::Garment g = garment::assemble(pattern, 0.04, fabric::Material{});
  try {
    dress_as_placed(g, pattern, far_away());
    FAIL() << "no error";
  } catch (const GeometryError& e) {
    const std::string what = e.what();
    EXPECT_NE(what.find("front"), std::string::npos) << what;
    EXPECT_NE(what.find("does not part them"), std::string::npos) << what;
    EXPECT_FALSE(e.hint().empty());
  }
}

TEST(DressAsPlaced, PanelMissingFromThePatternIsNamed) {
  pattern::Pattern pattern = two_squares(0.3);
  const garment::Garment g = garment::assemble(pattern, 0.04, fabric::Material{});
  pattern.panels[1].name = "other";
  try {
    dress_as_placed(g, pattern, far_away());
    FAIL() << "no error";
  } catch (const GeometryError& e) {
    EXPECT_NE(std::string(e.what()).find("back"), std::string::npos) << e.what();
  }
}

}  // namespace
}  // namespace loosefit::dress

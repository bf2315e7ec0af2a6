#include "loosefit/drape/free_fall.h"

#include <gtest/gtest.h>

#include "loosefit/drape/drape_session.h"
#include "loosefit/garment/assemble.h"
#include "support/shapes.h"
#include "support/simple_patterns.h"

namespace loosefit::drape {
namespace {

using namespace testing_support;

/// Two squares of 20 cm, sewn together at one edge or not at all.
pattern::Pattern two_squares(bool sewn) {
  pattern::Pattern pattern;
  pattern.panels = {rectangle_panel("left", 0.2, 0.2), rectangle_panel("right", 0.2, 0.2)};
  pattern.panels[1].translation = {0.2, 0, 0};
  if (sewn) pattern.stitches = {stitch(0, 1, 1, 3)};
  return pattern;
}

struct TwoSquares {
  garment::Garment garment;
  std::vector<Vec3> x;

  explicit TwoSquares(bool sewn)
      : garment(garment::assemble(two_squares(sewn), 0.05, fabric::Material{})) {
    for (std::size_t v = 0; v < garment.vertex_uv.size(); ++v)
      x.emplace_back(garment.vertex_uv[v].x() + (garment.vertex_panel[v] == 0 ? 0 : 0.2),
                     garment.vertex_uv[v].y(), 0);
  }
  void move(int panel, const Vec3& by) {
    for (std::size_t v = 0; v < x.size(); ++v)
      if (garment.vertex_panel[v] == panel) x[v] += by;
  }
  std::string falling(const Vec3& by = Vec3::Zero()) const {
    std::vector<Vec3> moved = x;
    for (Vec3& p : moved) p += by;
    const geometry::Box3 body(Vec3(-0.3, -0.2, 0), Vec3(0.3, 0.2, 1.7));
    return FreeFall({&garment}).falling(moved, body).value_or(Stop{}).text();
  }
};

TEST(FreeFall, ClothAtOrAboveTheBodyMayStillBeHeld) {
  const TwoSquares both(true);
  EXPECT_EQ(both.falling({0, 0, 1}), "");
  EXPECT_EQ(both.falling({0, 0, 5}), "") << "it will fall on the head";
  EXPECT_EQ(both.falling({0, 0, -1e-9}), "the cloth falls freely: it touches the body nowhere");
  TwoSquares hanging = both;
  hanging.move(1, {0, 0, -0.5});
  EXPECT_EQ(hanging.falling({0, 0, 0.1}), "") << "the upper half is at the feet";
}

TEST(FreeFall, ClothAsideFallsWhenItMissesTheBodyHoweverItTurns) {
  const TwoSquares both(true);
  // Centroid at (0.2, 0.1), corners √(0.2² + 0.1²) = 0.224 m away: the body ends at x = 0.3.
  EXPECT_EQ(both.falling({0.3 + 0.224 + 0.10 - 0.2 - 0.01, 0, 1}), "");
  EXPECT_NE(both.falling({0.3 + 0.224 + 0.10 - 0.2 + 0.01, 0, 1}), "");
}

TEST(FreeFall, LoosePieceIsNamed) {
  TwoSquares apart(false);
  EXPECT_EQ(apart.falling({0, 0, 1}), "");
  EXPECT_NE(apart.falling({0, 0, -1}).find("the cloth falls freely"), std::string::npos);
  apart.move(1, {0, 0, -1.01});
  EXPECT_EQ(apart.falling({0, 0, 1}),
            "panel right is sewn to nothing that stays on the body and falls freely");
  // Where pieces are near each other the one may hang on the other.
  TwoSquares hooked(false);
  hooked.move(0, {0, 0, 0.005});
  EXPECT_EQ(hooked.falling({0, 0, -0.002}), "");
}

TEST(FreeFall, DrapeEndsAtOnceAndSaysSo) {
  body::Body ball;
  ball.surface = support::sphere(0.1, 24, 48);
  ball.segment.assign(ball.surface.vertices.size(), body::Segment::torso);
  ball.side.assign(ball.surface.vertices.size(), 0);
  pattern::Pattern pattern;
  pattern.panels = {rectangle_panel("cloth", 0.2, 0.2)};
  pattern.panels[0].translation = {0.5, 0, 0.3};
  const garment::GarmentHierarchy garment =
      garment::build_hierarchy(pattern, 0.04, fabric::Material{});
  Progress silent;
  DrapeOptions options;
  options.time_budget = 20;
  options.max_iterations = 400;
  const Drape drape = drape_garment(
      garment, fabric::Material{}, [&](double) { return ball; }, options, silent);
  EXPECT_FALSE(drape.certificate.settled());
  EXPECT_EQ(drape.certificate.stop_reason, "the cloth falls freely: it touches the body nowhere");
  ASSERT_TRUE(drape.unsettled);
  EXPECT_EQ(drape.unsettled->why, drape.certificate.stop_reason);
  EXPECT_LT(drape.report.total().iterations, 20);
}

}  // namespace
}  // namespace loosefit::drape

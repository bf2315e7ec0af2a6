#include <gtest/gtest.h>

#include <cmath>

#include "loosefit/base/error.h"
#include "loosefit/garment/check_attachment.h"
#include "loosefit/garment/hierarchy.h"
#include "loosefit/geometry/mesh_topology.h"
#include "loosefit/pattern/hole.h"
#include "support/simple_patterns.h"

// Holes cut into pieces, through all levels of a garment and for what is sewn onto it.
namespace loosefit::garment {
namespace {

using namespace testing_support;

/// A tube of one rectangle whose sides are sewn, with a round hole in it.
pattern::Pattern tube(double radius, const Vec2& centre) {
  pattern::Pattern pattern;
  pattern.panels = {rectangle_panel("tube", 0.8, 0.6)};
  pattern.stitches = {stitch(0, 1, 0, 3)};
  pattern::PanelHole hole{"armhole hole", {}};
  for (int i = 0; i < 90; ++i)
    hole.points.push_back(centre +
                          radius * Vec2(std::cos(2 * kPi * i / 90), std::sin(2 * kPi * i / 90)));
  pattern.panels[0].holes = {hole};
  return pattern;
}

TEST(CutHole, EveryLevelHasItAndComesNearerToItsArea) {
  for (const double radius : {0.05, 0.09, 0.14}) {
    const pattern::Pattern pattern = tube(radius, {0.35, 0.3});
    const GarmentHierarchy hierarchy = build_hierarchy(pattern, 0.006, {});
    ASSERT_GE(hierarchy.levels.size(), 2u);
    double error = 1;
    for (const Garment& level : hierarchy.levels) {
      EXPECT_EQ(geometry::MeshTopology(level.triangles).boundary_loops().size(), 3u);
      const double now = std::abs(level.area - pattern::cloth_area(pattern.panels[0]));
      EXPECT_LT(now, 0.5 * error);
      error = now;
    }
    EXPECT_LT(error, 0.005 * kPi * radius * radius);
  }
}

TEST(CutHole, NothingIsSewnOntoIt) {
  const pattern::Pattern pattern = tube(0.1, {0.4, 0.3});
  for (const double angle : {0.0, 1.0, 2.5, 4.0}) {
    const Vec2 out(std::cos(angle), std::sin(angle));
    Attachment board;
    board.name = "board";
    board.panel = "tube";
    board.part = Board{};
    Board& part = std::get<Board>(board.part);
    part.size = {0.02, 0.02};
    part.centre = Vec2(0.4, 0.3) + 0.12 * out;
    EXPECT_NO_THROW(check_attachment(board, pattern));
    part.centre = Vec2(0.4, 0.3) + 0.08 * out;
    try {
      check_attachment(board, pattern);
      FAIL() << angle;
    } catch (const InvalidInput& error) {
      EXPECT_NE(std::string(error.what()).find("armhole hole"), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace loosefit::garment

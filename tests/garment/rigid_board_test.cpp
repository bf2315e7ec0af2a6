#include "loosefit/garment/rigid_board.h"

#include <gtest/gtest.h>

#include <numeric>
#include <random>

#include "loosefit/base/error.h"
#include "loosefit/garment/board_material.h"
#include "loosefit/garment/hierarchy.h"
#include "loosefit/geometry/flat_triangle.h"
#include "support/simple_patterns.h"

namespace loosefit::garment {
namespace {

using namespace testing_support;

pattern::Pattern square() {
  pattern::Pattern p;
  p.panels = {rectangle_panel("front", .4, .4)};
  return p;
}

Board drawn_board(std::mt19937& rng) {
  std::uniform_real_distribution<double> u(0, 1);
  Board board;
  board.centre = {.15 + .1 * u(rng), .15 + .1 * u(rng)};
  if (u(rng) < 0.3)
    board.radius = 0.008 + 0.02 * u(rng);
  else
    board.size = {.015 + .04 * u(rng), .015 + .04 * u(rng)};
  board.angle = 6 * u(rng);
  board.mass = .02;
  return board;
}

TEST(RigidBoard, ItsOutlineIsEdgesOfTheMeshOnEveryLevel) {
  std::mt19937 rng(5);
  for (int k = 0; k < 12; ++k) {
    const Board board = drawn_board(rng);
    const double edge = k % 3 == 0 ? .02 : k % 3 == 1 ? .014 : .007;
    const GarmentHierarchy h = build_hierarchy(square(), edge, {}, {{"imu", "front", board}});
    const double area = board.radius > 0 ? kPi * board.radius * board.radius : board.size.prod();
    for (const Garment& g : h.levels) {
      ASSERT_EQ(g.rigid_boards.size(), 1u);
      const Garment::RigidBoard& b = g.rigid_boards[0];
      EXPECT_NEAR(b.area, area, 1e-9) << "triangles fill the footprint, no more and no less";
      for (std::size_t i = 0; i < b.vertices.size(); ++i) {
        Vec2 there = Vec2::Zero();
        for (int c = 0; c < 3; ++c) there += b.weights[i][c] * b.leader_uv[c];
        EXPECT_LT((there - g.vertex_uv[b.vertices[i]]).norm(), 1e-12);
        EXPECT_LT(b.weights[i].cwiseAbs().maxCoeff(), 2.5) << "leaders lie far apart";
      }
    }
    EXPECT_GE(h.finest().rigid_boards[0].triangles.size(), 6u) << "enough to lie on a body";
    // The mesh gets no finer far from the board.
    EXPECT_LT(h.levels[0].triangles.size(),
              1.6 * build_hierarchy(square(), edge, {}).levels[0].triangles.size() + 60);
  }
}

TEST(RigidBoard, NextToTheRimItCoversWhatTheMeshCanFollow) {
  Board board;
  board.size = {.05, .04};
  board.mass = .01;
  for (const Vec2& at : {Vec2(.01, .2), Vec2(.3, .4), Vec2(0, 0), Vec2(.028, .2)}) {
    board.centre = at;
    const Garment g = build_hierarchy(square(), .014, {}, {{"imu", "front", board}}).finest();
    ASSERT_EQ(g.rigid_boards.size(), 1u);
    EXPECT_GT(g.rigid_boards[0].area, .2 * board.size.prod());
    EXPECT_NEAR(std::accumulate(g.vertex_mass.begin(), g.vertex_mass.end(), 0.0), g.mass, 1e-12);
  }
}

TEST(RigidBoard, TwoOfThemShareNoVertexAndMayNotOverlap) {
  std::mt19937 rng(9);
  Board one = drawn_board(rng), two = one;
  one.radius = two.radius = 0;
  one.size = two.size = {.03, .03};
  one.angle = two.angle = 0;
  for (const double apart : {.031, .033, .045}) {
    two.centre = one.centre + Vec2(apart, 0);
    const GarmentHierarchy h =
        build_hierarchy(square(), .014, {}, {{"a", "front", one}, {"b", "front", two}});
    for (const Garment& g : h.levels) {
      std::vector<int> met(g.vertex_count, 0);
      for (const Garment::RigidBoard& b : g.rigid_boards)
        for (int v : b.vertices) EXPECT_EQ(met[v]++, 0);
    }
    EXPECT_EQ(h.finest().rigid_boards.size(), 2u) << apart;
  }
  two.centre = one.centre + Vec2(.01, .01);
  try {
    build_hierarchy(square(), .014, {}, {{"a", "front", one}, {"b", "front", two}});
    FAIL() << "accepted";
  } catch (const InvalidInput& e) {
    EXPECT_EQ(e.place().key, "attachment b.position");
    EXPECT_EQ(e.found(), "a rigid board over the rigid board a");
  }
  two.bending = 0.1;  // flexible: may lie over it
  EXPECT_EQ(build_hierarchy(square(), .014, {}, {{"a", "front", one}, {"b", "front", two}})
                .finest()
                .rigid_boards.size(),
            1u);
}

TEST(RigidBoard, ItsCentreOfMassIsHalfItsThicknessOffOnItsSide) {
  Board board;
  board.centre = {.2, .2};
  board.size = {.04, .03};
  board.mass = .02;
  board.thickness = .006;
  const auto built = [&] {
    return build_hierarchy(square(), .02, {}, {{"imu", "front", board}}).finest();
  };
  EXPECT_EQ(built().rigid_boards[0].offset, .003);
  EXPECT_TRUE(built().triangle_padding.empty());
  board.side = Board::Side::inside;
  const Garment g = built();
  EXPECT_EQ(g.rigid_boards[0].offset, -.003);
  double padded = 0;
  for (std::size_t t = 0; t < g.triangles.size(); ++t)
    padded += g.triangle_padding[t] * geometry::flat_area(g.triangle_uv[t]);
  EXPECT_NEAR(padded, .006 * .04 * .03, 1e-12);
}

TEST(BoardMaterial, RigidityIsThatOfAPlate) {
  // D = E t³/(12 (1 − ν²)) by hand.
  EXPECT_NEAR(plate_rigidity_of(*find_board_material("fr4"), 1.6e-3), 7.66, 0.01);
  EXPECT_NEAR(plate_rigidity_of(*find_board_material("fr4"), 0.8e-3), 0.957, 0.001);
  EXPECT_NEAR(plate_rigidity_of(*find_board_material("silicone"), 5e-3), 0.0271, 0.0002);
  EXPECT_EQ(find_board_material("wood"), nullptr);
  BoardMake board;
  EXPECT_TRUE(board.is_rigid());
  board.material = "polyimide";
  board.thickness = 1e-4;
  EXPECT_FALSE(board.is_rigid());
  fabric::Material cloth;
  cloth.stiffness_warp = cloth.stiffness_weft = 100;
  EXPECT_NEAR(sheet_stiffness(board, cloth).bending, 2.36e-4, 1e-6);
  EXPECT_EQ(sheet_stiffness(board, cloth).membrane_factor, 100);
  board.bending = 2e-3;
  EXPECT_EQ(sheet_stiffness(board, cloth).bending, 2e-3) << "who has measured knows better";
}

}  // namespace
}  // namespace loosefit::garment

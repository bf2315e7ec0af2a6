#include "loosefit/pattern/piece_facing.h"

#include <gtest/gtest.h>

#include "loosefit/base/error.h"
#include "loosefit/pattern/heap.h"
#include "loosefit/pattern/piece_names.h"
#include "loosefit/pattern/place_pieces.h"
#include "support/simple_patterns.h"

namespace loosefit::pattern {
namespace {

using namespace testing_support;

PieceFacings facings(const Pattern& pattern) {
  return tell_facings(pattern, know_garment(pattern));
}

/// Front, back and a sleeve of two halves, each sewn to its side of the armhole.
Pattern with_half_sleeves() {
  Pattern pattern;
  for (const char* name : {"torso_front", "torso_back"})
    pattern.panels.push_back(polygon_panel(
        name, {{0, 0}, {0.5, 0}, {0.5, 0.4}, {0.5, 0.6}, {0.4, 0.65}, {0.1, 0.65}, {0, 0.6}}));
  // Longer along the arm than the armhole is high: the seam to the other half is the longest.
  for (const char* name : {"left_sleeve_f", "left_sleeve_b"})
    pattern.panels.push_back(rectangle_panel(name, 0.5, 0.2));
  pattern.stitches = {stitch(0, 1, 1, 1), stitch(0, 2, 2, 3), stitch(1, 6, 3, 1),
                      stitch(2, 0, 3, 0), stitch(2, 2, 3, 2)};
  return pattern;
}

TEST(PieceFacing, HalvesOfASleeveLieBeforeAndBehindTheArm) {
  const PieceFacings told = facings(with_half_sleeves());
  EXPECT_EQ(told.of[2], Facing::front);
  EXPECT_EQ(told.of[3], Facing::back);
  EXPECT_TRUE(told.half_sleeve[2] && told.half_sleeve[3]);
  EXPECT_TRUE(told.guessed.empty());
  Pattern placed = with_half_sleeves();
  place_pieces(placed);
  EXPECT_EQ(placed.panels[2].label, "arm");
  EXPECT_EQ(placed.panels[0].label, "body");
}

TEST(PieceFacing, ASleeveInOnePieceGoesRoundTheArm) {
  Pattern pattern = with_half_sleeves();
  pattern.panels.pop_back();
  pattern.stitches = {stitch(0, 1, 1, 1), stitch(0, 2, 2, 3), stitch(2, 0, 2, 2)};
  const PieceFacings told = facings(pattern);
  EXPECT_EQ(told.of[2], Facing::left_arm);
  EXPECT_FALSE(told.half_sleeve[2]);
}

/// Two T of one outline each, sewn along their straight tops, sides and undersides of the sleeves.
Pattern kimono(double body, double arm, double length, double sleeve) {
  Pattern pattern;
  const double b = body / 2, a = b + arm, under = length - sleeve;
  for (const char* name : {"front", "back"})
    pattern.panels.push_back(polygon_panel(name, {{-b, 0},
                                                  {b, 0},
                                                  {b, under},
                                                  {a, under},
                                                  {a, length},
                                                  {-a, length},
                                                  {-a, under},
                                                  {-b, under}}));
  pattern.stitches = {stitch(0, 4, 1, 4), stitch(0, 1, 1, 7), stitch(0, 2, 1, 6),
                      stitch(0, 7, 1, 1), stitch(0, 6, 1, 2)};
  return pattern;
}

// Its top is longer than its hem, as a hem is longer than a neck.
TEST(PlacePieces, ATunicOfTwoTStandsAsItIsDrawn) {
  for (const double body : {0.45, 0.6})
    for (const double arm : {0.2, 0.45})
      for (const double length : {0.6, 1.2}) {
        Pattern pattern = kimono(body, arm, length, 0.2);
        place_pieces(pattern);
        for (const Panel& panel : pattern.panels)
          EXPECT_GT(panel.rotation.col(1).z(), 0.99) << panel.name << ' ' << body << ' ' << arm;
      }
}

/// Front, a back in two halves and two sleeves that no name tells a hand of: no known garment.
Pattern with_back_seam() {
  Pattern pattern;
  const std::vector<Vec2> half = {{0, 0},     {0.25, 0},   {0.25, 0.4},
                                  {0.2, 0.6}, {0.1, 0.65}, {0, 0.65}};
  std::vector<Vec2> whole(half.begin() + 1, half.end() - 1), twin;
  for (auto at = half.rbegin() + 1; at != half.rend() - 1; ++at)
    whole.emplace_back(-at->x(), at->y());
  for (auto at = half.rbegin(); at != half.rend(); ++at) twin.emplace_back(-at->x(), at->y());
  pattern.panels = {polygon_panel("FRONT", whole), polygon_panel("BACK", half),
                    polygon_panel("BACK_mirrored", twin)};
  for (const char* name : {"SLEEVE", "SLEEVE_mirrored"})
    pattern.panels.push_back(
        polygon_panel(name, {{-0.15, 0}, {0.15, 0}, {0.18, 0.15}, {0, 0.27}, {-0.18, 0.15}}));
  // Sides, the middle of the back, shoulders; then the left armhole and the right one.
  pattern.stitches = {stitch(0, 0, 2, 3), stitch(0, 6, 1, 1), stitch(1, 5, 2, 5),
                      stitch(0, 2, 2, 1), stitch(0, 4, 1, 3), stitch(0, 1, 4, 2),
                      stitch(2, 2, 4, 3), stitch(0, 5, 3, 3), stitch(1, 2, 3, 2)};
  return pattern;
}

TEST(PieceFacing, SleevesThatNoNameTellsGoAlongTheArmOfTheirArmhole) {
  ASSERT_TRUE(know_garment(with_back_seam()).kind.empty());
  const PieceFacings told = facings(with_back_seam());
  EXPECT_EQ(told.of[4], Facing::left_arm) << "at the side of the front that is seen right";
  EXPECT_EQ(told.of[3], Facing::right_arm);
  EXPECT_TRUE(told.guessed.empty());
}

TEST(PieceFacing, ATurnThatIsAskedForSetsAPieceUpright) {
  for (const int turns : {0, 1, 2, 3}) {
    Pattern pattern;
    for (const char* name : {"piece_front", "piece_back"})
      pattern.panels.push_back(
          polygon_panel(name, {{0, 0}, {0.5, 0}, {0.45, 0.3}, {0.4, 0.6}, {0, 0.6}}));
    pattern.stitches = {stitch(0, 4, 1, 4)};
    place_pieces(pattern, {{0, turns}});
    // What was at the top, the right, the bottom or the left of the drawing.
    const Vec3 up =
        pattern.panels[0].rotation *
        std::vector<Vec3>{Vec3::UnitY(), Vec3::UnitX(), -Vec3::UnitY(), -Vec3::UnitX()}[turns];
    EXPECT_GT(up.z(), 0.99) << turns;
    EXPECT_LT(pattern.panels[0].rotation.col(2).y(), -0.99) << turns;
  }
}

TEST(PieceFacing, WhatIsCalledLeftBetweenFrontAndBackIsASide) {
  Pattern pattern;
  for (const char* name : {"panel_front", "left", "panel_back", "right"})
    pattern.panels.push_back(
        polygon_panel(name, {{0, 0}, {0.3, 0}, {0.5, 0.3}, {0.3, 0.6}, {0, 0.6}}));
  for (int i = 0; i < 4; ++i) pattern.stitches.push_back(stitch(i, 1, (i + 1) % 4, 4));
  const PieceFacings told = facings(pattern);
  EXPECT_EQ(told.of[1], Facing::left_side);
  EXPECT_EQ(told.of[3], Facing::right_side);
  // Sewn to the front alone it is part of the front.
  pattern.stitches.erase(pattern.stitches.begin() + 1);
  EXPECT_EQ(facings(pattern).of[1], Facing::front);
}

TEST(PieceFacing, TheSideFileSaysWhatNamesDoNot) {
  Pattern pattern;
  pattern.panels = {rectangle_panel("a", 0.4, 0.6), rectangle_panel("b", 0.4, 0.6)};
  pattern.stitches = {stitch(0, 1, 1, 3), stitch(0, 3, 1, 1)};
  Pattern untold = pattern;
  EXPECT_THROW(place_pieces(untold), GeometryError) << "the order of a file tells nothing";
  pattern.panels[0].part = "back", pattern.panels[1].part = "front";
  EXPECT_EQ(facings(pattern).of[0], Facing::back);
  EXPECT_EQ(facings(pattern).of[1], Facing::front);
}

TEST(PieceNames, LettersBeforeAPieceSayItsHand) {
  const PieceWords a = words_of("lfsleeve"), b = words_of("Rback"), c = words_of("rbsleeve");
  EXPECT_TRUE(a.left && a.front && a.sleeve && !a.right && !a.back);
  EXPECT_TRUE(b.right && b.back && !b.left);
  EXPECT_TRUE(c.right && c.back && c.sleeve);
  EXPECT_TRUE(words_of("Lhood").left && words_of("Lhood").hood);
  for (const char* name : {"label", "ruffle", "leg", "legging", "ribbon", "lace", "lining"})
    EXPECT_FALSE(words_of(name).left || words_of(name).right) << name;
}

TEST(Heap, PanelsOnEachOtherAndThoseAtTheOriginAreOne) {
  Pattern pattern;
  for (const char* name : {"front", "back", "sleeve"})
    pattern.panels.push_back(rectangle_panel(name, 0.4, 0.6));
  EXPECT_TRUE(lies_in_a_heap(pattern));
  for (Panel& panel : pattern.panels)
    panel.translation = {0.1, -0.2, 1}, panel.rotation = facing_rotation(Facing::front, true);
  EXPECT_TRUE(lies_in_a_heap(pattern)) << "all at one place";
  pattern.panels[1].translation.y() = 0.2;
  EXPECT_TRUE(lies_in_a_heap(pattern)) << "most at one place";
  pattern.panels[2].translation = {0.6, -0.2, 1};
  EXPECT_FALSE(lies_in_a_heap(pattern));
}

TEST(Heap, PocketsAndLiningsAreNone) {
  Pattern pattern;
  pattern.panels = {rectangle_panel("front", 0.4, 0.6), rectangle_panel("pocket", 0.1, 0.1),
                    rectangle_panel("back", 0.4, 0.6)};
  for (int p = 0; p < 3; ++p) {
    pattern.panels[p].translation = {0, p < 2 ? -0.2 : 0.2, 1};
    pattern.panels[p].rotation = facing_rotation(p < 2 ? Facing::front : Facing::back, true);
  }
  EXPECT_FALSE(lies_in_a_heap(pattern));
  Pattern lined = pattern;
  lined.panels[1] = pattern.panels[0], lined.panels.push_back(pattern.panels[2]);
  EXPECT_FALSE(lies_in_a_heap(lined));
  Pattern one;
  one.panels = {rectangle_panel("tube", 0.8, 0.6)};
  EXPECT_FALSE(lies_in_a_heap(one));
}

}  // namespace
}  // namespace loosefit::pattern

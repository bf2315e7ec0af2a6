#include "loosefit/pattern/known_half_sleeves.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/unsewn_garments.h"

// Sleeves that are drawn as a front and a back.
namespace loosefit::pattern {
namespace {

using namespace testing_support;

/// Half of a left sleeve as its front, seen from outside: cap, underarm, cuff, top.
std::vector<pattern::CurveChain> half(double cap, double wide = 0.17) {
  const double high = std::sqrt(cap * cap - wide * wide);
  return {straight({0, 0.5}, {-wide, 0.5 - high}), straight({-wide, 0.5 - high}, {-0.10, 0.1}),
          straight({-0.10, 0.1}, {0, 0.1}), straight({0, 0.1}, {0, 0.5})};
}

/// Front, back, and the halves of both sleeves.
Pattern with_halves(double wide = 0.17) {
  Pattern pattern = unsewn_tshirt();
  pattern.panels.resize(2);
  const double front = EdgePath(pattern.panels[0], 2).length(),
               back = EdgePath(pattern.panels[1], 2).length();
  // The seams of the two halves are equally long where their caps are.
  const auto of_front = half(std::max(front, back), wide), of_back = of_front;
  pattern.panels.push_back(numbered_panel("SLEEVE_L_FRONT", of_front));
  pattern.panels.push_back(mirrored_panel("SLEEVE_L_BACK", of_back));
  pattern.panels.push_back(mirrored_panel("SLEEVE_R_FRONT", of_front));
  pattern.panels.push_back(numbered_panel("SLEEVE_R_BACK", of_back));
  return pattern;
}

bool sews(const KnownGarment& known, const std::string& name, int first, int second) {
  return std::ranges::any_of(known.seams, [&](const ChainSeam& seam) {
    return seam.name == name && seam.first.front().panel == first &&
           seam.second.front().panel == second;
  });
}

TEST(KnownHalfSleeves, FrontAndBackOfASleeveAreSewnToTheirSidesOfTheArmhole) {
  const Pattern pattern = with_halves();
  const KnownGarment known = know_garment(pattern);
  EXPECT_EQ(known.kind, "shirt with sleeves in halves");
  EXPECT_EQ(known.seams.size(), 12u);
  EXPECT_TRUE(sews(known, "armhole_front_L", 2, 0));
  EXPECT_TRUE(sews(known, "armhole_back_L", 3, 1));
  EXPECT_TRUE(sews(known, "armhole_front_R", 4, 0));
  EXPECT_TRUE(sews(known, "underarm_R", 4, 5));
  EXPECT_TRUE(sews(known, "sleeve_top_L", 2, 3));
  // But for the lengths of the caps, which are drawn alike before and behind.
  for (const std::string& doubt : known.doubts)
    EXPECT_TRUE(doubt.starts_with("seam armhole_back")) << doubt;
}

TEST(KnownHalfSleeves, TheOutlineTellsTheHandWhereNamesDoNot) {
  Pattern pattern = with_halves();
  for (const int p : {2, 4}) pattern.panels[p].name = p == 2 ? "FRONT SLEEVE" : "FRONT SLEEVE 2";
  for (const int p : {3, 5}) pattern.panels[p].name = p == 3 ? "BACK SLEEVE" : "BACK SLEEVE 2";
  const KnownGarment known = know_garment(pattern);
  EXPECT_TRUE(sews(known, "armhole_front_L", 2, 0));
  EXPECT_TRUE(sews(known, "armhole_front_R", 4, 0));
  // Names that say the other hand are a doubt.
  pattern.panels[2].name = "SLEEVE_R_FRONT", pattern.panels[4].name = "SLEEVE_L_FRONT";
  const KnownGarment crossed = know_garment(pattern);
  EXPECT_TRUE(std::ranges::any_of(crossed.doubts, [](const std::string& doubt) {
    return doubt.find("different arms") != std::string::npos;
  }));
}

TEST(KnownHalfSleeves, SeamsThatAreAsLongTellNoHand) {
  // Caps that run nearly across the grain: top and underarm differ by millimetres.
  Pattern pattern = with_halves();
  const double cap = EdgePath(pattern.panels[2], 0).length();
  pattern = with_halves(cap - 1e-4);
  const auto doubted = [](const Pattern& of) {
    return std::ranges::any_of(know_garment(of).doubts, [](const std::string& doubt) {
      return doubt.find("on top of the arm is not told") != std::string::npos;
    });
  };
  const KnownGarment named = know_garment(pattern);
  EXPECT_EQ(named.kind, "shirt with sleeves in halves");
  EXPECT_FALSE(doubted(pattern)) << "the names tell";
  Pattern unnamed = with_halves();
  for (Pattern* of : {&pattern, &unnamed})
    for (int p = 2; p < 6; ++p)
      of->panels[p].name =
          std::string(p % 2 == 0 ? "FRONT" : "BACK") + " SLEEVE " + std::string(p < 4 ? "A" : "B");
  EXPECT_TRUE(doubted(pattern));
  EXPECT_FALSE(doubted(unnamed)) << "the outline tells";
}

TEST(KnownHalfSleeves, WhatFitsNoArmholeOrLacksItsOtherHalfIsNone) {
  Pattern pattern = with_halves();
  pattern.panels.pop_back();
  EXPECT_EQ(know_garment(pattern).kind, "tank top");
  Pattern small = with_halves();
  for (int p = 2; p < 6; ++p)
    for (Vec2& v : small.panels[p].vertices) v *= 0.5;
  EXPECT_EQ(know_garment(small).kind, "tank top");
}

TEST(KnownHalfSleeves, TheyLieBeforeAndBehindTheArmOfTheirSide) {
  Pattern pattern = with_halves();
  std::vector<Notch> notches;
  sew_chains(pattern, know_garment(pattern).seams, notches);
  place_pieces(pattern);
  for (int p = 2; p < 6; ++p) {
    const Panel& panel = pattern.panels[p];
    SCOPED_TRACE(panel.name);
    EXPECT_EQ(panel.label, "arm");
    const bool front = p % 2 == 0, left = p < 4;
    EXPECT_LT(panel.rotation.col(2).y() * (front ? 1 : -1), -0.9);
    Vec3 middle = Vec3::Zero();
    for (const Vec2& v : panel.vertices)
      middle += (panel.rotation * Vec3(v.x(), v.y(), 0) + panel.translation) / 4;
    EXPECT_GT(middle.x() * (left ? 1 : -1), 0.2);
  }
}

}  // namespace
}  // namespace loosefit::pattern

#include <gtest/gtest.h>

#include <algorithm>

#include "loosefit/drape/openings.h"
#include "loosefit/fabric/material.h"
#include "loosefit/garment/assemble.h"
#include "support/unsewn_garments.h"

// Garments that hang on one shoulder have one armhole.
namespace loosefit::drape {
namespace {

using namespace testing_support;
using kinds::OpeningUse;

/// \param shoulder height of the shoulder; the edge over the bare one begins there
std::vector<pattern::CurveChain> outline(double shoulder = 0.63) {
  return {straight({-0.28, 0}, {0.28, 0}),
          straight({0.28, 0}, {0.26, 0.40}),
          curved({0.26, 0.40}, {0.22, 0.40}, {0.17, 0.46}, {0.17, shoulder - 0.03}),
          straight({0.17, shoulder - 0.03}, {0.08, shoulder}),
          straight({0.08, shoulder}, {-0.26, 0.40}),
          straight({-0.26, 0.40}, {-0.28, 0})};
}

std::vector<Opening> openings(bool left) {
  pattern::Pattern pattern;
  pattern.panels = {left ? numbered_panel("FRONT", outline()) : mirrored_panel("FRONT", outline()),
                    left ? mirrored_panel("BACK", outline()) : numbered_panel("BACK", outline())};
  pattern = from_nothing(pattern);
  return garment_openings(garment::assemble(pattern, 0.02, fabric::Material{}), pattern);
}

int count(const std::vector<Opening>& openings, OpeningUse use) {
  return static_cast<int>(std::ranges::count(openings, use, &Opening::use));
}

TEST(OneShoulder, ItsArmholeIsTheArmsAndTheEdgeOverTheBareShoulderNobodysAlone) {
  for (const bool left : {true, false}) {
    const std::vector<Opening> found = openings(left);
    ASSERT_EQ(found.size(), 3u);
    EXPECT_EQ(count(found, OpeningUse::left_arm), left ? 1 : 0);
    EXPECT_EQ(count(found, OpeningUse::right_arm), left ? 0 : 1);
    EXPECT_EQ(count(found, OpeningUse::hem), 1);
    EXPECT_EQ(count(found, OpeningUse::unknown), 1);
    for (const Opening& o : found)
      if (o.use == OpeningUse::left_arm || o.use == OpeningUse::right_arm) {
        EXPECT_GT(o.placed.x() * (left ? 1 : -1), 0.1);
      }
  }
}

TEST(OneShoulder, AnOrdinaryTankTopAndASkirtHaveNoSingleArmhole) {
  pattern::Pattern tank = unsewn_tshirt();
  tank.panels.resize(2);
  tank = from_nothing(tank);
  const auto found = garment_openings(garment::assemble(tank, 0.02, fabric::Material{}), tank);
  EXPECT_EQ(count(found, OpeningUse::left_arm), 1);
  EXPECT_EQ(count(found, OpeningUse::right_arm), 1);
  const pattern::Pattern skirt = from_nothing(unsewn_skirt());
  for (const Opening& o :
       garment_openings(garment::assemble(skirt, 0.02, fabric::Material{}), skirt))
    EXPECT_NE(o.use, OpeningUse::left_arm);
}

/// Front and back upright before and behind the middle.
void stand_up(pattern::Pattern& pattern) {
  pattern.panels[0].rotation << 1, 0, 0, 0, 0, -1, 0, 1, 0;
  pattern.panels[0].translation = Vec3(0, -0.2, 0.4);
  pattern.panels[1].rotation << -1, 0, 0, 0, 0, 1, 0, 1, 0;
  pattern.panels[1].translation = Vec3(0, 0.2, 0.4);
}

/// A skirt whose side seams are left open for pockets, on the left or on both sides.
std::vector<Opening> with_slits(int slits, const std::string& name) {
  const auto panel = [&](const std::string& called) {
    std::vector<Vec2> right;
    for (const double y : {0.0, 0.41, 0.56, 0.60}) right.emplace_back(0.30 - y / 6, y);
    std::vector<pattern::CurveChain> loop = {straight(Vec2(-0.30, 0), right[0])};
    for (int i = 0; i < 3; ++i) loop.push_back(straight(right[i], right[i + 1]));
    loop.push_back(straight(right[3], Vec2(-right[3].x(), 0.60)));
    for (int i = 2; i >= 0; --i) loop.push_back(loop[1 + i].mirrored().reversed());
    return numbered_panel(called, loop);
  };
  pattern::Pattern pattern;
  pattern.panels = {panel(name + "front"), panel(name + "back")};
  stand_up(pattern);
  for (const int e : {1, 2, 3, 5, 6, 7}) {
    if ((e == 2 && slits > 0) || (e == 6 && slits > 1)) continue;
    pattern.stitches.push_back(stitch(0, e, 1, 8 - e));
  }
  return garment_openings(garment::assemble(pattern, 0.02, fabric::Material{}), pattern);
}

TEST(OneShoulder, TheSlitOfAPocketInASkirtIsNoArmhole) {
  for (const int slits : {1, 2})
    for (const char* name : {"skirt ", ""}) {
      if (slits == 2 && *name == 0) continue;  // without names it may be a short top
      SCOPED_TRACE(name + std::to_string(slits));
      const std::vector<Opening> found = with_slits(slits, name);
      ASSERT_EQ(found.size(), 2u + slits);
      EXPECT_EQ(count(found, OpeningUse::left_arm) + count(found, OpeningUse::right_arm), 0);
      EXPECT_EQ(count(found, OpeningUse::neck), 0);
      EXPECT_EQ(count(found, OpeningUse::upper), *name ? 1 : 0);
      EXPECT_EQ(count(found, OpeningUse::hem), *name ? 1 : 0);
    }
}

TEST(OneShoulder, SlitsInTheSideSeamsOfTrousersAreNoArmholes) {
  const std::vector<Vec2> corners = {{-0.25, 0},   {-0.03, 0},    {0, 0.5},     {0.03, 0},
                                     {0.25, 0},    {0.24, 0.6},   {0.22, 0.75}, {0.20, 0.8},
                                     {-0.20, 0.8}, {-0.22, 0.75}, {-0.24, 0.6}};
  pattern::Pattern pattern;
  pattern.panels = {polygon_panel("leg front", corners), polygon_panel("leg back", corners)};
  stand_up(pattern);
  for (const int e : {4, 6, 8, 10}) pattern.stitches.push_back(stitch(0, e, 1, 14 - e));
  for (const int e : {1, 2}) pattern.stitches.push_back(stitch(0, e, 1, 3 - e));
  const std::vector<Opening> found =
      garment_openings(garment::assemble(pattern, 0.02, fabric::Material{}), pattern);
  ASSERT_EQ(found.size(), 5u);
  EXPECT_EQ(count(found, OpeningUse::left_arm) + count(found, OpeningUse::neck), 0);
  EXPECT_EQ(count(found, OpeningUse::waist), 1);
  EXPECT_EQ(count(found, OpeningUse::left_leg), 1);
  EXPECT_EQ(count(found, OpeningUse::right_leg), 1);
}

}  // namespace
}  // namespace loosefit::drape

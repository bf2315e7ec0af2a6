#include "loosefit/pattern/open_rims.h"

#include <gtest/gtest.h>

namespace loosefit::pattern {
namespace {

// Panels of four sides each: bottom, right, top, left.
std::vector<int> quads(int count) {
  std::vector<int> panels;
  for (int i = 0; i < 4 * count; ++i) panels.push_back(i / 4);
  return panels;
}
std::vector<double> lengths(int count) {
  std::vector<double> level;
  for (int i = 0; i < count; ++i) level.insert(level.end(), {0.5, 0, 0.4, 0});
  return level;
}

TEST(OpenRims, ASheetHasOneATubeTwoABagOne) {
  EXPECT_EQ(rims_of(quads(1), {}).size(), 1u);
  EXPECT_EQ(rims_of(quads(1), {{1, 3}}).size(), 2u);
  EXPECT_EQ(rims_of(quads(2), {}).size(), 2u);
  EXPECT_EQ(rims_of(quads(2), {{1, 7}}).size(), 1u);
  const std::vector<Rim> tube = rims_of(quads(2), {{1, 7}, {3, 5}});
  ASSERT_EQ(tube.size(), 2u);
  EXPECT_EQ(tube[0], (Rim{0, 4}));
  EXPECT_EQ(tube[1], (Rim{2, 6}));
  EXPECT_EQ(rims_of(quads(2), {{1, 7}, {3, 5}, {0, 4}}).size(), 1u);
  EXPECT_TRUE(rims_of(quads(2), {{1, 7}, {3, 5}, {0, 4}, {2, 6}}).empty());
}

TEST(OpenRims, HemsAndWaistsStayOpenWhereSidesAreSewn) {
  std::vector<SidePair> pairs = {{0, 4}, {1, 7}, {3, 5}, {2, 6}};
  keep_open(quads(2), lengths(2), pairs);
  EXPECT_EQ(pairs, (std::vector<SidePair>{{1, 7}, {3, 5}}));
}

// Of four gores the hem of one sewn to that of the next but one.
TEST(OpenRims, OfAShutRingTheLongestLevelSeamsAreOpened) {
  std::vector<SidePair> pairs = {{1, 7}, {5, 11}, {9, 15}, {13, 3},
                                 {0, 8}, {4, 12}, {2, 10}, {6, 14}};
  keep_open(quads(4), lengths(4), pairs);
  for (const SidePair& side : std::vector<SidePair>{{1, 7}, {5, 11}, {9, 15}, {13, 3}})
    EXPECT_TRUE(std::count(pairs.begin(), pairs.end(), side));
  EXPECT_GE(rims_of(quads(4), pairs).size(), 2u);
}

TEST(OpenRims, WhatIsOpenIsLeftAsItIs) {
  const std::vector<SidePair> before = {{1, 7}, {2, 4}};
  std::vector<SidePair> pairs = before;
  keep_open(quads(2), lengths(2), pairs);
  EXPECT_EQ(pairs, before);
  pairs.clear();
  keep_open({}, {}, pairs);
  EXPECT_TRUE(pairs.empty());
}

}  // namespace
}  // namespace loosefit::pattern

#include "loosefit/pattern/known_skirt.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "loosefit/pattern/known_garment.h"
#include "loosefit/pattern/place_pieces.h"
#include "loosefit/pattern/propose_seams.h"
#include "support/simple_patterns.h"

// Skirts of gores without names, as people draw them.
namespace loosefit::pattern {
namespace {

using namespace testing_support;

constexpr int kHem = 0, kRight = 1, kWaist = 2, kLeft = 3;  // edges of a gore

Panel gore(const std::string& name, double waist = 0.19, double hem = 0.33, double x = 0) {
  const double in = (hem - waist) / 2;
  return polygon_panel(name, {{x, 0}, {x + hem, 0}, {x + in + waist, 0.6}, {x + in, 0.6}});
}

Pattern gores(int count, double waist = 0.19, double hem = 0.33) {
  Pattern pattern;
  for (int i = 0; i < count; ++i)
    pattern.panels.push_back(gore("path" + std::to_string(i + 1), waist, hem, 0.4 * i));
  return pattern;
}

std::vector<std::pair<int, int>> edges_of(const SeamProposals& proposals) {
  std::vector<std::pair<int, int>> sewn;
  for (const SeamProposal& p : proposals.seams)
    for (const auto* run : {&p.seam.first, &p.seam.second})
      for (const Stitch::Side& side : *run) sewn.emplace_back(side.panel, side.edge);
  return sewn;
}

bool sews(const SeamProposals& proposals, int panel, int edge) {
  return std::ranges::count(edges_of(proposals), std::pair(panel, edge)) == 1;
}

TEST(KnownSkirt, FourPlainGoresAreSewnSideToSideAndStayOpenAboveAndBelow) {
  const SeamProposals found = propose_seams(gores(4), {});
  ASSERT_EQ(found.seams.size(), 4u);
  for (int p = 0; p < 4; ++p) {
    EXPECT_TRUE(sews(found, p, kRight) && sews(found, p, kLeft)) << p;
    EXPECT_FALSE(sews(found, p, kWaist) || sews(found, p, kHem)) << p;
  }
  EXPECT_FALSE(found.known.certain()) << "no name says which are before";
}

TEST(KnownSkirt, AHoleThatMayBeANeckLeavesItInDoubt) {
  const auto is_certain = [](const std::string& name, double side) {
    Pattern pattern;
    pattern.panels = {gore("front", 0.6, 0.64), gore("back", 0.6, 0.64, 0.8)};
    if (side > 0)
      pattern.panels[0].holes = {
          {name, {{0.2, 0.3}, {0.2 + side, 0.3}, {0.2 + side, 0.3 + side}, {0.2, 0.3 + side}}}};
    return know_garment(pattern).certain();
  };
  EXPECT_TRUE(is_certain("", 0)) << "a skirt without a hole";
  EXPECT_TRUE(is_certain("hole", 0.03));
  EXPECT_TRUE(is_certain("pocket hole", 0.12));
  EXPECT_FALSE(is_certain("hole", 0.12));
  EXPECT_FALSE(is_certain("neck hole", 0.05));
}

TEST(KnownSkirt, AStripIsSewnToTheTopEdgesWithOneOfItsLongSides) {
  for (const int count : {2, 4}) {
    SCOPED_TRACE(count);
    Pattern pattern = count == 2 ? gores(2, 0.38, 0.56) : gores(4);
    pattern.panels.push_back(rectangle_panel("path9", 0.74, 0.06));
    const SeamProposals found = propose_seams(pattern, {});
    for (int p = 0; p < count; ++p) {
      EXPECT_TRUE(sews(found, p, kRight) && sews(found, p, kLeft) && sews(found, p, kWaist)) << p;
      EXPECT_FALSE(sews(found, p, kHem)) << p;
    }
    EXPECT_TRUE(sews(found, count, 1) && sews(found, count, 3)) << "end to end";
    EXPECT_NE(sews(found, count, 0), sews(found, count, 2)) << "one long side";
  }
}

// Where the hem is as long as the waist a strip is a waistband.
TEST(KnownSkirt, AStripThatFitsHemAndWaistGoesToTheWaist) {
  Pattern pattern = gores(2, 0.5, 0.5);
  pattern.panels.push_back(rectangle_panel("path9", 0.95, 0.06));
  const SeamProposals found = propose_seams(pattern, {});
  EXPECT_TRUE(sews(found, 0, kWaist) && sews(found, 1, kWaist));
  EXPECT_FALSE(sews(found, 0, kHem) || sews(found, 1, kHem));
}

TEST(KnownSkirt, NamesSayTheWayRound) {
  Pattern pattern = gores(4);
  pattern.panels[0].name = "left", pattern.panels[1].name = "back skirt";
  pattern.panels[2].name = "right", pattern.panels[3].name = "front skirt";
  const KnownGarment known = know_garment(pattern);
  ASSERT_EQ(known.kind, "skirt");
  EXPECT_TRUE(known.certain()) << known.doubts.front();
  const auto joins = [&](int a, int b) {
    return std::ranges::any_of(known.seams, [&](const ChainSeam& s) {
      return s.first[0].panel == a && s.second[0].panel == b && s.first[0].edge == kRight &&
             s.second[0].edge == kLeft;
    });
  };
  // Seen from outside the wearer's left is at the right of the front.
  EXPECT_TRUE(joins(3, 0) && joins(0, 1) && joins(1, 2) && joins(2, 3));
  EXPECT_EQ(known.pieces[0].role, PieceRole::side_skirt);
  EXPECT_EQ(known.pieces[0].side, 1);
  std::vector<Notch> none;
  sew_chains(pattern, known.seams, none);
  place_pieces(pattern);
  EXPECT_GT(pattern.panels[0].rotation.col(2).x(), 0.9) << "the left side looks to the left";
  EXPECT_LT(pattern.panels[2].rotation.col(2).x(), -0.9);
  EXPECT_LT(pattern.panels[3].rotation.col(2).y(), -0.9);
  EXPECT_GT(pattern.panels[1].rotation.col(2).y(), 0.9);
}

TEST(KnownSkirt, OtherSidesAreOtherPieces) {
  Pattern pattern = gores(2);
  pattern.panels.push_back(rectangle_panel("pouch", 0.2, 0.25));
  const KnownSkirt found = know_skirt(pattern, {0, 1, 2});
  ASSERT_EQ(found.pieces.size(), 2u);
  EXPECT_EQ(found.pieces[0].first, 0);
  EXPECT_EQ(found.pieces[1].first, 1);
  EXPECT_FALSE(know_skirt(pattern, {0, 2}).found());
}

// A tube top and a bandeau are rectangles, too.
TEST(KnownSkirt, NamesOfTopsAreDoubts) {
  const auto doubts = [](const std::string& before) {
    Pattern pattern = gores(2, 0.40, 0.40);
    pattern.panels[0].name = before + "front", pattern.panels[1].name = before + "back";
    return know_garment(pattern).doubts;
  };
  for (const char* name : {"tube top ", "Bandeau_", "Poncho ", "Oberteil "}) {
    const auto all = doubts(name);
    EXPECT_TRUE(std::any_of(all.begin(), all.end(), [](const std::string& why) {
      return why.find("is of a top by its name, of a skirt by its shape") != std::string::npos;
    })) << name;
  }
  const auto all = doubts("skirt ");
  EXPECT_TRUE(std::none_of(all.begin(), all.end(), [](const std::string& why) {
    return why.find("by its name") != std::string::npos;
  }));
}

// Two pieces of a garment that is not known: each hem would agree with the other in length.
TEST(ProposeSeams, NeitherHemToHemNorWaistToWaistWhereTheSidesAreSewn) {
  Pattern pattern = gores(2, 0.38, 0.56);
  pattern.panels[0].name = "yoke_1", pattern.panels[1].name = "yoke_2";
  pattern.panels.push_back(rectangle_panel("path9", 0.74, 0.06));
  const SeamProposals found = propose_seams(pattern, {});
  ASSERT_TRUE(found.known.kind.empty());
  for (int p = 0; p < 2; ++p) {
    EXPECT_TRUE(sews(found, p, kRight) && sews(found, p, kLeft) && sews(found, p, kWaist)) << p;
    EXPECT_FALSE(sews(found, p, kHem)) << p;
  }
  EXPECT_NE(sews(found, 2, 0), sews(found, 2, 2)) << "one long side of the strip";
  EXPECT_TRUE(sews(found, 2, 1) && sews(found, 2, 3));
}

}  // namespace
}  // namespace loosefit::pattern

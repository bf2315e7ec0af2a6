#include "loosefit/pattern/known_garment.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "loosefit/base/error.h"
#include "loosefit/pattern/least_cost.h"
#include "loosefit/pattern/outline.h"
#include "loosefit/pattern/pattern_check.h"
#include "loosefit/pattern/piece_names.h"
#include "loosefit/pattern/place_pieces.h"
#include "loosefit/pattern/propose_seams.h"
#include "support/unsewn_garments.h"

namespace loosefit::pattern {
namespace {

using namespace testing_support;

/// Ends of all seams lie together when the sewn panels are flat fronts and backs above each other.
double worst_difference(const Pattern& pattern) {
  double worst = 0;
  for (const Stitch& s : pattern.stitches) {
    const double a = EdgePath(pattern.panels[s.first.panel], s.first.edge).length(),
                 b = EdgePath(pattern.panels[s.second.panel], s.second.edge).length();
    worst = std::max(worst, std::abs(a - b) / std::max(a, b));
  }
  return worst;
}

TEST(KnownGarment, ATShirtIsSewnInOneWay) {
  Pattern shirt = unsewn_tshirt();
  const KnownGarment known = know_garment(shirt);
  EXPECT_EQ(known.kind, "t-shirt");
  ASSERT_TRUE(known.certain()) << known.doubts[0];
  EXPECT_EQ(known.pieces[0].role, PieceRole::front);
  EXPECT_EQ(known.pieces[1].role, PieceRole::back);
  EXPECT_EQ(known.pieces[2].side, -1) << "its cap is cut out more at x > 0: a right sleeve";
  EXPECT_EQ(known.pieces[3].side, 1);
  std::vector<Notch> notches;
  sew_chains(shirt, known.seams, notches);
  EXPECT_EQ(shirt.stitches.size(), 10u);  // each cap is sewn to two armholes
  EXPECT_LT(worst_difference(shirt), 0.02);
  check_pattern(shirt);
  // One vertex per corner: of the sewn garment four loops are left open (neck, hem, two cuffs).
  std::set<std::pair<int, int>> sewn;
  for (const Stitch& s : shirt.stitches)
    for (const auto& side : {s.first, s.second})
      EXPECT_TRUE(sewn.insert({side.panel, side.edge}).second);
  std::size_t edges = 0;
  for (const Panel& panel : shirt.panels) edges += panel.edges.size();
  EXPECT_EQ(edges - sewn.size(), 6u);  // front neck and hem, back neck and hem, two cuffs
}

TEST(KnownGarment, NeitherNamesNorHowPiecesLieMatterWhereShapesTell) {
  for (int variant = 0; variant < 8; ++variant) {
    SCOPED_TRACE(variant);
    Pattern shirt = unsewn_tshirt();
    if (variant & 1)
      for (std::size_t p = 0; p < 4; ++p) shirt.panels[p].name = "piece_" + std::to_string(p);
    if (variant & 2) {  // on their heads
      turn_panel(shirt.panels[0]);
      turn_panel(shirt.panels[2]);
    }
    if (variant & 4) {  // other first edges
      rotate_edges(shirt.panels[1], 3);
      rotate_edges(shirt.panels[3], 2);
    }
    const KnownGarment known = know_garment(shirt);
    EXPECT_EQ(known.kind, "t-shirt");
    EXPECT_TRUE(known.certain()) << known.doubts[0];
    EXPECT_EQ(known.pieces[0].role, PieceRole::front) << "its neck is deeper";
    EXPECT_EQ(known.pieces[0].upright, !(variant & 2));
    EXPECT_EQ(known.pieces[2].side, -1);
  }
}

TEST(KnownGarment, TrousersSkirtsAndTankTopsAreTold) {
  Pattern trousers = unsewn_trousers();
  const KnownGarment legs = know_garment(trousers);
  EXPECT_EQ(legs.kind, "trousers");
  EXPECT_TRUE(legs.certain()) << legs.doubts[0];
  EXPECT_EQ(legs.seams.size(), 6u);
  std::vector<Notch> notches;
  sew_chains(trousers, legs.seams, notches);
  EXPECT_LT(worst_difference(trousers), 0.02);
  Pattern tank = unsewn_tshirt();
  tank.panels.resize(2);
  EXPECT_EQ(know_garment(tank).kind, "tank top");
  EXPECT_TRUE(know_garment(tank).certain());
  EXPECT_EQ(know_garment(unsewn_skirt()).kind, "skirt");
  EXPECT_TRUE(know_garment(unsewn_skirt()).certain());
}

TEST(KnownGarment, ShortTrousersAreToldWhicheverWayUpTheyLie) {
  const Pattern shorts = unsewn_trousers(0.84, 1.00, 0.26, 0.34);
  // Their hems are nearly as long as their outseams.
  const std::vector<double> lengths = edge_lengths(shorts.panels[0]);
  ASSERT_LT(lengths[1], 1.7 * lengths[0]);
  for (const bool turned : {false, true}) {
    Pattern pattern = shorts;
    if (turned)
      for (Panel& panel : pattern.panels) turn_panel(panel);
    const KnownGarment known = know_garment(pattern);
    EXPECT_EQ(known.kind, "trousers");
    EXPECT_TRUE(known.certain()) << known.doubts.front();
    for (const KnownPiece& piece : known.pieces) EXPECT_EQ(piece.upright, !turned);
    const auto outseam = std::ranges::find(known.seams, "outseam_L", &ChainSeam::name);
    ASSERT_NE(outseam, known.seams.end());
    EXPECT_EQ(outseam->first.front().edge, outseam->first.front().panel == 0 ? 1 : 3);
  }
}

TEST(KnownGarment, ASkirtOnItsHeadOrWithoutAFrontIsNotSewnUnasked) {
  Pattern head = unsewn_skirt();
  turn_panel(head.panels[1]);
  EXPECT_FALSE(know_garment(head).certain()) << "its hem would be sewn to a waist";
  EXPECT_FALSE(know_garment(unsewn_skirt(1.0, 0.9)).certain()) << "it tapers";
  Pattern alike = unsewn_skirt();
  alike.panels[0].name = "skirt_1", alike.panels[1].name = "skirt_2";
  EXPECT_TRUE(know_garment(alike).certain()) << "front and back may change places";
  alike.panels[1] = unsewn_skirt(0.84).panels[0];
  alike.panels[1].name = "skirt_2";
  EXPECT_FALSE(know_garment(alike).certain());
}

TEST(KnownGarment, ARaglanShirtIsSewnByTheLengthsOfItsRaglans) {
  Pattern shirt = unsewn_raglan();
  const KnownGarment known = know_garment(shirt);
  EXPECT_EQ(known.kind, "raglan shirt");
  ASSERT_TRUE(known.certain()) << known.doubts[0];
  EXPECT_EQ(known.pieces[2].side, -1) << "its longer raglan, the back's, lies at x < 0";
  EXPECT_EQ(known.pieces[3].side, 1);
  std::vector<Notch> notches;
  sew_chains(shirt, known.seams, notches);
  EXPECT_EQ(shirt.stitches.size(), 8u);
  EXPECT_LT(worst_difference(shirt), 0.02);
  EXPECT_TRUE(place_pieces(shirt).empty());
  EXPECT_GT(shirt.panels[2].rotation.col(1).x(), 0.5);
}

TEST(KnownGarment, AHoodIsSewnFromTheMiddleOfTheFront) {
  for (const double strip : {0.0, 0.08}) {
    SCOPED_TRACE(strip);
    Pattern shirt = unsewn_hoodie(strip);
    turn_panel(shirt.panels[4]);
    rotate_edges(shirt.panels[5], 2);
    const KnownGarment known = know_garment(shirt);
    EXPECT_EQ(known.kind, "hooded t-shirt");
    ASSERT_TRUE(known.certain()) << known.doubts[0];
    EXPECT_EQ(known.pieces[4].side, -1);
    EXPECT_EQ(known.pieces[5].side, 1);
    std::vector<Notch> notches;
    sew_chains(shirt, known.seams, notches);
    EXPECT_LT(worst_difference(shirt), 0.02);
    // Each half is sewn to one half of the front's neck, which is parted in its middle.
    int at_front = 0;
    for (const Stitch& stitch : shirt.stitches) {
      if (stitch.name.find("hood_neck") != 0) continue;
      EXPECT_GE(stitch.first.panel, 4);
      if (stitch.second.panel != 0) continue;
      ++at_front;
      const EdgePath edge(shirt.panels[0], stitch.second.edge);
      EXPECT_EQ(edge.at(0.5).x() > 0, stitch.first.panel == 5) << "the wearer's left is at x > 0";
    }
    EXPECT_EQ(at_front, 2);
    EXPECT_TRUE(place_pieces(shirt).empty());
    for (const int p : {4, 5}) {
      const Panel& half = shirt.panels[p];
      EXPECT_NEAR(half.rotation.col(2).x(), p == 5 ? 1 : -1, 1e-12) << "its outside";
      const auto height = [&](const Stitch::Side& side) {
        const Vec2 q = EdgePath(half, side.edge).at(0.5);
        return (half.rotation * Vec3(q.x(), q.y(), 0) + half.translation).z();
      };
      const KnownGarment again = know_garment(shirt);
      EXPECT_LT(height(again.pieces[p].sections[0].sides(half, p)[0]),
                height(again.pieces[p].sections[p == 5 ? 1 : 2].sides(half, p)[0]) - 0.05);
    }
  }
}

TEST(KnownGarment, ARaglanShirtMayHaveAHood) {
  Pattern shirt = unsewn_raglan();
  double neck = 0;
  for (const int p : {0, 1, 2, 2}) neck += EdgePath(shirt.panels[p], 3).length();
  const auto half = testing_support::hood_half(neck / 2);
  shirt.panels.push_back(numbered_panel("hood", half));
  shirt.panels.push_back(mirrored_panel("hood_2", half));
  const KnownGarment known = know_garment(shirt);
  EXPECT_EQ(known.kind, "hooded raglan shirt");
  ASSERT_TRUE(known.certain()) << known.doubts[0];
  std::vector<Notch> notches;
  sew_chains(shirt, known.seams, notches);
  EXPECT_LT(worst_difference(shirt), 0.02);
}

TEST(KnownGarment, HoodsThatDoNotFitAreDoubts) {
  Pattern faced = unsewn_hoodie(0.1);
  Panel facing = faced.panels.back();
  facing.name = "hood_facing";
  faced.panels.insert(faced.panels.end() - 1, facing);
  for (const ChainSeam& seam : know_garment(faced).seams)
    for (const auto* chain : {&seam.first, &seam.second})
      for (const Stitch::Side& side : *chain)
        EXPECT_NE(faced.panels[side.panel].name, "hood_facing") << seam.name;
  Pattern alike = unsewn_hoodie();
  alike.panels[4] = alike.panels[5];
  alike.panels[4].name = "hood_3";
  EXPECT_NE(know_garment(alike).doubts.at(0).find("are for the same side"), std::string::npos);
  Pattern named = unsewn_hoodie();
  named.panels[4].name = "hood left";
  EXPECT_NE(know_garment(named).doubts.at(0).find("say different sides"), std::string::npos);
  Pattern wide = unsewn_hoodie(0.1);
  wide.panels.pop_back();  // without its strip the neck is too long for it
  EXPECT_NE(know_garment(wide).doubts.at(0).find("seam hood_neck"), std::string::npos);
  Pattern one = unsewn_hoodie();
  one.panels.pop_back();
  EXPECT_NE(know_garment(one).doubts.at(0).find("no part of it"), std::string::npos);
}

TEST(SewChains, AClosedRunMayBeginWithinAnEdge) {
  Pattern shirt = unsewn_hoodie();
  std::vector<Notch> notches;
  ChainSeam seam{"round", {{5, 0}, {4, 2}}, {{0, 4}, {1, 4}}, false};
  const ChainSeam left{"shoulder_L", {{0, 3}}, {{1, 5}}, false};
  const double front = EdgePath(shirt.panels[0], 4).length(),
               all = chain_length(shirt, seam.second);
  seam.begin = 0.25 * front / all;
  Pattern open = shirt;
  EXPECT_THROW(sew_chains(open, {seam}, notches), GeometryError) << "the left shoulder is open";
  EXPECT_EQ(open.panels[0].edges.size(), shirt.panels[0].edges.size());
  sew_chains(shirt, {left, seam}, notches);
  ASSERT_FALSE(shirt.stitches.empty());
  const Stitch& last = shirt.stitches.back();
  EXPECT_EQ(last.second.panel, 0) << "the second run begins at a quarter of the front's neck";
  EXPECT_NEAR(EdgePath(shirt.panels[0], 4).length(), 0.25 * front, 1e-6);
}

TEST(KnownGarment, DoubtsKeepItFromBeingSewnUnasked) {
  Pattern more = unsewn_tshirt();
  more.panels.push_back(more.panels[2]);
  more.panels.back().name = "cuff";
  EXPECT_EQ(know_garment(more).kind, "t-shirt");
  EXPECT_FALSE(know_garment(more).certain());
  Pattern longer = unsewn_tshirt();  // the side seams of the back are 5 % longer
  for (Vec2& v : longer.panels[1].vertices)
    if (v.y() < 0.1) v.y() -= 0.02;
  EXPECT_EQ(know_garment(longer).kind, "t-shirt");
  EXPECT_FALSE(know_garment(longer).certain());
  Pattern twice = unsewn_tshirt();
  twice.panels[3] = twice.panels[2];
  twice.panels[3].name = "sleeve_2";
  EXPECT_FALSE(know_garment(twice).certain()) << "two right sleeves";
  Pattern fronts = unsewn_tshirt();
  fronts.panels[1] = fronts.panels[0];
  fronts.panels[1].name = "front_2";
  EXPECT_FALSE(know_garment(fronts).certain());
  Pattern one = unsewn_tshirt();
  one.panels.pop_back();
  EXPECT_FALSE(know_garment(one).certain());
}

TEST(ProposeSeams, PairsTheSidesOfAGarmentThatNobodyKnows) {
  // Two rectangles with notches: a bag.
  Pattern bag;
  bag.panels = {rectangle_panel("front", 0.40, 0.30), rectangle_panel("back", 0.40, 0.30)};
  const SeamProposals found = propose_seams(bag, {{0, 1, 0.25}, {1, 3, 0.75}});
  EXPECT_TRUE(found.known.kind.empty() || !found.seams.empty());
  ASSERT_FALSE(found.seams.empty());
  bool notched = false;
  for (const SeamProposal& p : found.seams)
    notched = notched || (p.seam.first[0].edge == 1 && p.seam.second[0].edge == 3) ||
              (p.seam.first[0].edge == 3 && p.seam.second[0].edge == 1);
  EXPECT_TRUE(notched) << "edges whose notches meet";
}

TEST(ProposeSeams, ASleeveIsSewnToItselfNotToThatOfTheOtherArm) {
  // With an unusual front it is no garment that is known, and lengths are all there is.
  Pattern shirt = unsewn_tshirt();
  shirt.panels[0] = rectangle_panel("front", 0.5, 0.6);
  const SeamProposals found = propose_seams(shirt, {});
  int underarms = 0;
  for (const SeamProposal& proposal : found.seams) {
    const int a = proposal.seam.first.front().panel, b = proposal.seam.second.front().panel;
    EXPECT_FALSE(a >= 2 && b >= 2 && a != b) << proposal.seam.name;
    underarms += a >= 2 && a == b;
  }
  EXPECT_EQ(underarms, 2);
}

/// Two long sides that differ: no copy of itself.
std::vector<CurveChain> half_sleeve() {
  return {straight({0, 0.5}, {-0.17, 0.35}), straight({-0.17, 0.35}, {-0.10, 0.1}),
          straight({-0.10, 0.1}, {0, 0.1}), straight({0, 0.1}, {0, 0.5})};
}

bool sews(const SeamProposals& proposals, int one, int other) {
  return std::ranges::any_of(proposals.seams, [&](const SeamProposal& proposal) {
    const int a = proposal.seam.first.front().panel, b = proposal.seam.second.front().panel;
    return std::minmax(a, b) == std::minmax(one, other);
  });
}

TEST(ProposeSeams, NoSleeveIsSewnToACopyWhicheverComesFirst) {
  // The third is the copy of both others, of which only the first is its own.
  Pattern pattern;
  pattern.panels = {numbered_panel("sleeve_a", half_sleeve()),
                    numbered_panel("sleeve_b", half_sleeve()),
                    mirrored_panel("sleeve", half_sleeve())};
  const SeamProposals found = propose_seams(pattern, {});
  EXPECT_FALSE(sews(found, 0, 2));
  EXPECT_FALSE(sews(found, 1, 2));
}

TEST(ProposeSeams, FrontAndBackOfOneSleeveAreSewnToEachOther) {
  Pattern pattern;
  pattern.panels = {numbered_panel("sleeve", half_sleeve()),
                    mirrored_panel("sleeve_back", half_sleeve())};
  EXPECT_TRUE(sews(propose_seams(pattern, {}), 0, 1));
}

TEST(LeastCost, FindsTheBestOfAllAssignments) {
  const std::vector<std::vector<double>> cost = {
      {4, 1, 3, 7}, {2, 0, 5, 1}, {3, 2, 2, 6}, {9, 3, 1, 8}};
  std::vector<int> order = {0, 1, 2, 3};
  double least = 1e9;
  do {
    double sum = 0;
    for (int i = 0; i < 4; ++i) sum += cost[i][order[i]];
    least = std::min(least, sum);
  } while (std::next_permutation(order.begin(), order.end()));
  const std::vector<int> found = least_cost_assignment(cost);
  double sum = 0;
  for (int i = 0; i < 4; ++i) sum += cost[i][found[i]];
  EXPECT_EQ(sum, least);
  EXPECT_EQ(std::set<int>(found.begin(), found.end()).size(), 4u);
  EXPECT_TRUE(least_cost_assignment({}).empty());
}

TEST(SewChains, CutsEdgesWhereTheOtherSideBegins) {
  Pattern pattern;
  pattern.panels = {rectangle_panel("long", 0.6, 0.2), rectangle_panel("a", 0.2, 0.2),
                    rectangle_panel("b", 0.4, 0.2)};
  std::vector<Notch> notches = {{0, 0, 0.5}, {0, 1, 0.5}};
  // The bottom of the long one, from left to right, to the bottoms of b and a.
  sew_chains(pattern, {{"hem", {{0, 0}}, {{1, 0}, {2, 0}}, false}}, notches);
  ASSERT_EQ(pattern.stitches.size(), 2u);
  const Panel& cut = pattern.panels[0];
  ASSERT_EQ(cut.edges.size(), 5u);
  EXPECT_EQ(cut.edges[0].name, "edge_0_1");
  EXPECT_EQ(cut.edges[1].name, "edge_0_2");
  EXPECT_NEAR(EdgePath(cut, 0).length(), 0.4, 1e-9);
  // End meets start: the beginning of the long edge is sewn to the end of the run.
  EXPECT_EQ(pattern.stitches[0].second.panel, 2);
  EXPECT_EQ(pattern.stitches[1].second.panel, 1);
  EXPECT_EQ(notches[0].edge, 0);
  EXPECT_NEAR(notches[0].along, 0.75, 1e-9);
  EXPECT_EQ(notches[1].edge, 2);
  check_pattern(pattern);
  // Parallel runs meet start to start.
  Pattern other;
  other.panels = pattern.panels;
  other.panels[0] = rectangle_panel("long", 0.6, 0.2);
  std::vector<Notch> none;
  sew_chains(other, {{"hem", {{0, 0}}, {{1, 0}, {2, 0}}, true}}, none);
  EXPECT_EQ(other.stitches[0].second.panel, 1);
  EXPECT_NEAR(EdgePath(other.panels[0], 0).length(), 0.2, 1e-9);
  EXPECT_TRUE(other.stitches[0].right_wrong);
  EXPECT_THROW(sew_chains(other, {{"x", {}, {{1, 1}}, false}}, none), GeometryError);
}

TEST(PieceNames, AreUnderstoodInSeveralLanguages) {
  EXPECT_TRUE(words_of("Vorderteil").front);
  EXPECT_TRUE(words_of("Rückenteil").back);
  EXPECT_TRUE(words_of("Ärmel links").sleeve);
  EXPECT_TRUE(words_of("Ärmel links").left);
  EXPECT_TRUE(words_of("frontLeft").front);
  EXPECT_TRUE(words_of("frontLeft").left);
  EXPECT_TRUE(words_of("TEE-BK-01").back);
  EXPECT_TRUE(words_of("manche").sleeve);
  EXPECT_FALSE(words_of("manche").fold);
  EXPECT_FALSE(words_of("sleeve_mirrored").fold);
  EXPECT_FALSE(words_of("blank").back);
  EXPECT_FALSE(words_of("front-back").front) << "says both";
}

TEST(PlacePieces, FrontsLieBeforeBacksBehindAndSleevesBeside) {
  Pattern shirt = unsewn_tshirt();
  turn_panel(shirt.panels[1]);
  std::vector<Notch> notches;
  sew_chains(shirt, know_garment(shirt).seams, notches);
  EXPECT_TRUE(place_pieces(shirt).empty());
  EXPECT_LT((shirt.panels[0].rotation.col(2) + Vec3::UnitY()).norm(), 1e-12);
  EXPECT_LT((shirt.panels[1].rotation.col(2) - Vec3::UnitY()).norm(), 1e-12);
  EXPECT_LT(shirt.panels[0].translation.y(), -0.1);
  EXPECT_GT(shirt.panels[1].translation.y(), 0.1);
  EXPECT_EQ(shirt.panels[2].label, "arm");
  EXPECT_GT(shirt.panels[2].rotation.col(1).x(), 0.5) << "the cap of a right sleeve to the middle";
  EXPECT_LT(shirt.panels[3].rotation.col(1).x(), -0.5);
  // Sewn edges of front and back lie at one height and one x.
  const auto at = [&](const Stitch::Side& side, double share) -> Vec3 {
    const Panel& panel = shirt.panels[side.panel];
    const Vec2 p = EdgePath(panel, side.edge).at(share);
    return panel.rotation * Vec3(p.x(), p.y(), 0) + panel.translation;
  };
  for (const Stitch& s : shirt.stitches) {
    EXPECT_NEAR(shirt.panels[s.first.panel].rotation.determinant(), 1, 1e-12);
    if (s.first.panel > 1 || s.second.panel > 1) continue;
    for (const double share : {0.0, 0.5, 1.0}) {
      const Vec3 gap = at(s.first, share) - at(s.second, 1 - share);
      EXPECT_LT(std::hypot(gap.x(), gap.z()), 0.005) << s.name << " " << share;
    }
  }
  // Trousers: legs beside each other, not through each other.
  Pattern trousers = unsewn_trousers();
  sew_chains(trousers, know_garment(trousers).seams, notches);
  place_pieces(trousers);
  const auto known = know_garment(trousers);
  for (std::size_t p = 0; p < 4; ++p) {
    double low = 1e9, high = -1e9;
    for (const Vec2& q : outline_polygon(trousers.panels[p])) {
      const Vec3 x =
          trousers.panels[p].rotation * Vec3(q.x(), q.y(), 0) + trousers.panels[p].translation;
      low = std::min(low, x.x()), high = std::max(high, x.x());
    }
    EXPECT_GT(known.pieces[p].side > 0 ? low : -high, 0.02);
  }
}

TEST(PlacePieces, ABackOnItsHeadIsTurnedByItsSeamsToTheFront) {
  // A tunic with sides of its own each, of no garment that is known.
  const std::vector<CurveChain> tunic = {
      straight({-0.2, 0}, {0.2, 0}),       straight({0.2, 0}, {0.4, 0.4}),
      straight({0.4, 0.4}, {0.25, 1.0}),   straight({0.25, 1.0}, {-0.25, 1.0}),
      straight({-0.25, 1.0}, {-0.4, 0.5}), straight({-0.4, 0.5}, {-0.2, 0})};
  Pattern pattern;
  pattern.panels = {numbered_panel("front", tunic), mirrored_panel("back", tunic)};
  turn_panel(pattern.panels[1]);
  for (const auto& [a, b] : {std::pair{1, 4}, {2, 3}, {4, 1}, {5, 0}})
    pattern.stitches.push_back({{0, a}, {1, b}, false, "side"});
  ASSERT_EQ(know_garment(pattern).kind, "");
  place_pieces(pattern);
  const auto at = [&](const Stitch::Side& side, double share) -> Vec3 {
    const Panel& panel = pattern.panels[side.panel];
    const Vec2 p = EdgePath(panel, side.edge).at(share);
    return panel.rotation * Vec3(p.x(), p.y(), 0) + panel.translation;
  };
  for (const Stitch& s : pattern.stitches)
    for (const double share : {0.0, 1.0}) {
      const Vec3 gap = at(s.first, share) - at(s.second, 1 - share);
      EXPECT_LT(std::hypot(gap.x(), gap.z()), 1e-9) << share;
    }
  EXPECT_NEAR(pattern.panels[1].rotation.col(2).y(), 1, 1e-12) << "its outside looks backwards";
}

TEST(PlacePieces, SaysWhatItCannotPlace) {
  Pattern loose = unsewn_tshirt();
  loose.stitches.push_back({{0, 1}, {1, 7}, false, "side"});
  EXPECT_THROW(place_pieces(loose), GeometryError);
  Pattern nameless;
  nameless.panels = {rectangle_panel("a", 0.4, 0.6), rectangle_panel("b", 0.4, 0.6)};
  nameless.stitches.push_back({{0, 1}, {1, 3}, false, "side"});
  try {
    place_pieces(nameless);
    ADD_FAILURE();
  } catch (const GeometryError& error) {
    EXPECT_NE(std::string(error.what()).find("front"), std::string::npos);
  }
}

}  // namespace
}  // namespace loosefit::pattern

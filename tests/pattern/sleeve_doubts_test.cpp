#include "loosefit/pattern/sleeve_doubts.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/unsewn_garments.h"

// T-shirts whose sleeves somebody sews otherwise than they are meant to be.
namespace loosefit::pattern {
namespace {

using namespace testing_support;

ChainSeam& seam(std::vector<ChainSeam>& seams, const std::string& name) {
  return *std::ranges::find(seams, name, &ChainSeam::name);
}

template <class Change>
std::vector<std::string> doubts(const Change& change) {
  Pattern shirt = unsewn_tshirt();
  std::vector<ChainSeam> seams = know_garment(shirt).seams;
  change(shirt, seams);
  std::vector<Notch> notches;
  sew_chains(shirt, seams, notches);
  return sleeve_doubts(shirt, know_garment(shirt));
}

bool tells(const std::vector<std::string>& doubts, const std::string& what) {
  return std::ranges::any_of(
      doubts, [&](const std::string& doubt) { return doubt.find(what) != std::string::npos; });
}

TEST(SleeveDoubts, AShirtSewnAsItIsMeantHasNone) {
  EXPECT_TRUE(doubts([](Pattern&, std::vector<ChainSeam>&) {}).empty());
}

TEST(SleeveDoubts, SleevesThatHaveChangedArmsAreTold) {
  const auto exchange = [](Pattern&, std::vector<ChainSeam>& seams) {
    std::swap(seam(seams, "armhole_L").second, seam(seams, "armhole_R").second);
  };
  EXPECT_TRUE(tells(doubts(exchange), "cut out more")) << "by the shape of the cap";
  const auto named = [&](Pattern& shirt, std::vector<ChainSeam>& seams) {
    shirt.panels[2].name = "sleeve right", shirt.panels[3].name = "sleeve left";
    exchange(shirt, seams);
  };
  EXPECT_TRUE(tells(doubts(named), "is called right and sewn to the left armhole"));
}

TEST(SleeveDoubts, ArmholesListedTheWrongWayRoundAreTold) {
  const auto turned = doubts([](Pattern&, std::vector<ChainSeam>& seams) {
    std::ranges::reverse(seam(seams, "armhole_R").second);
  });
  EXPECT_TRUE(tells(turned, "wrong order for the right armhole"));
  EXPECT_EQ(turned.size(), 1u);
}

TEST(SleeveDoubts, ACapSewnToBothSidesOfTheBodyIsTold) {
  const auto across = doubts([](Pattern&, std::vector<ChainSeam>& seams) {
    std::swap(seam(seams, "armhole_L").second[0], seam(seams, "armhole_R").second[1]);
  });
  EXPECT_TRUE(tells(across, "armholes of both sides"));
}

TEST(SleeveDoubts, PlacingTellsThemAndNamesThatHaveChangedPlaces) {
  Pattern shirt = unsewn_tshirt();
  std::vector<ChainSeam> seams = know_garment(shirt).seams;
  std::swap(seam(seams, "armhole_L").second, seam(seams, "armhole_R").second);
  std::vector<Notch> notches;
  sew_chains(shirt, seams, notches);
  EXPECT_TRUE(tells(place_pieces(shirt), "cut out more"));

  Pattern named = unsewn_tshirt();
  std::swap(named.panels[0].name, named.panels[1].name);
  const KnownGarment known = know_garment(named);
  EXPECT_FALSE(known.certain()) << "its front is the back by its shape";
  EXPECT_TRUE(tells(known.doubts, "may have changed places"));
  sew_chains(named, known.seams, notches);
  EXPECT_TRUE(tells(place_pieces(named), "may have changed places"));
}

}  // namespace
}  // namespace loosefit::pattern

#include "loosefit/base/text.h"

#include <gtest/gtest.h>

namespace loosefit {
namespace {

TEST(EditDistance, CountsSwapsAsOneAndIgnoresDashAndCase) {
  EXPECT_EQ(edit_distance("", "abc"), 3);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3);
  EXPECT_EQ(edit_distance("lenght", "length"), 1);
  EXPECT_EQ(edit_distance("Angular_Deviation", "angular-deviation"), 0);
}

TEST(ClosestMatch, FindsASlipAndRefusesAStranger) {
  const std::vector<std::string> keys = {"chest", "waist", "hip", "edge_length"};
  EXPECT_EQ(closest_match("cheast", keys), "chest");
  EXPECT_EQ(closest_match("edge_lenght", keys), "edge_length");
  EXPECT_EQ(closest_match("temperature", keys), "");
  EXPECT_EQ(closest_match(std::string(100000, 'x'), keys), "");
  EXPECT_EQ(closest_match("hop", {"hip", "hup"}), "hip") << "ties go to the earlier one";
}

TEST(DidYouMean, ListsAllWhenNothingIsNear) {
  EXPECT_EQ(did_you_mean("hipp", {"chest", "hip"}), "did you mean \"hip\"?");
  EXPECT_EQ(did_you_mean("zzzzz", {"chest", "hip"}), "known: chest, hip");
}

TEST(Shortest, ReadsBackToTheSameDouble) {
  for (double x : {0.1, 1.0 / 3, 4.41e-6, 1e300, -2.5}) EXPECT_EQ(std::stod(shortest(x)), x);
}

TEST(Printable, EscapesAndCuts) {
  EXPECT_EQ(printable("a\nb"), "a\\x0ab");
  EXPECT_EQ(printable(std::string(100, 'x'), 5), "xxxxx...");
}

}  // namespace
}  // namespace loosefit

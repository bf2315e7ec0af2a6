#include "loosefit/base/error.h"

#include <gtest/gtest.h>

namespace loosefit {
namespace {

TEST(InvalidInput, NamesPlaceFoundAndExpected) {
  const InvalidInput e({"a.toml", 7, "body.height"}, "17", "metres in 0.4 … 2.5", "metres?");
  EXPECT_STREQ(e.what(), "a.toml:7: body.height: found 17, expected metres in 0.4 … 2.5");
  EXPECT_EQ(e.hint(), "metres?");
  EXPECT_EQ(e.found(), "17");
  EXPECT_EQ(e.expected(), "metres in 0.4 … 2.5");
}

TEST(InvalidInput, IsToldAgainFromAnotherPlace) {
  const InvalidInput e({"", 0, "chest"}, "9 m", "0.35 to 1.8 m", "metres");
  const InvalidInput moved = e.at({"a.toml", 4, "body.measurements.chest"});
  EXPECT_STREQ(moved.what(),
               "a.toml:4: body.measurements.chest: found 9 m, expected 0.35 to 1.8 m");
  EXPECT_EQ(moved.hint(), "metres");
  EXPECT_EQ(moved.found(), "9 m");
  EXPECT_EQ(moved.expected(), "0.35 to 1.8 m");
  EXPECT_STREQ(InvalidInput("no arms").at({"a.toml", 0, ""}).what(), "a.toml: no arms");
  EXPECT_EQ(InvalidInput("no arms").found(), "");
}

TEST(InputPlace, LeavesOutWhatIsUnknown) {
  EXPECT_EQ((InputPlace{"a.json", 0, "panels.front"}).str(), "a.json: panels.front");
  EXPECT_EQ((InputPlace{"", 0, "--sex"}).str(), "--sex");
  EXPECT_EQ((InputPlace{"a.toml", 3, ""}).str(), "a.toml:3");
}

}  // namespace
}  // namespace loosefit

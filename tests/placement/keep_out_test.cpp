#include "loosefit/placement/keep_out.h"

#include <gtest/gtest.h>

#include "loosefit/base/error.h"

namespace loosefit::placement {
namespace {

KeepOut of(const std::string& text) {
  KeepOut keep_out;
  add_keep_out(text, keep_out);
  return keep_out;
}

std::string refusal(const std::string& text) {
  try {
    of(text);
  } catch (const InvalidInput& e) {
    return std::string(e.what()) + " / " + e.hint();
  }
  return "accepted";
}

TEST(KeepOut, RectangleByAnyTwoOppositeCorners) {
  const KeepOutZone zone = of("front:0.3,-0.1,0.1,0.2").zones.at(0);
  EXPECT_EQ(zone.panel, "front");
  EXPECT_DOUBLE_EQ(zone.distance({0.2, 0.1}), 0);
  EXPECT_DOUBLE_EQ(zone.distance({0.05, 0}), 0.05);
  EXPECT_DOUBLE_EQ(zone.distance({0.33, 0.24}), 0.05) << "from the corner";
}

TEST(KeepOut, DiscAndRegion) {
  const KeepOutZone zone = of("left sleeve:0.1,0.2,0.03").zones.at(0);
  EXPECT_EQ(zone.panel, "left sleeve");
  EXPECT_DOUBLE_EQ(zone.distance({0.1, 0.22}), 0);
  EXPECT_NEAR(zone.distance({0.14, 0.23}), 0.02, 1e-15);
  EXPECT_EQ(of("scapula_L").regions.at(0), body::Region::scapula_left);
  EXPECT_TRUE(KeepOut{}.empty());
  EXPECT_FALSE(of("abdomen").empty());
}

TEST(KeepOut, RefusesTheRestWithAHint) {
  EXPECT_NE(refusal("abdomin").find("did you mean \"abdomen\"?"), std::string::npos);
  for (const char* text :
       {"front:1,2", "front:1,2,3,4,5", "front:", ":1,2,3", "front:a,b,c", "front:1,2,nan",
        "front:1,2,3,", "front:1;2;3", "front:1,2,inf", "front:100,20,30", ""})
    EXPECT_NE(refusal(text).find("keep-out: found"), std::string::npos) << text;
  EXPECT_NE(refusal("front:0.1,0.1,0").find("radius must be above 0"), std::string::npos);
}

}  // namespace
}  // namespace loosefit::placement

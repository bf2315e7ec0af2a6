#include <gtest/gtest.h>

#include <algorithm>

#include "support/only_draped.h"

namespace loosefit::pipeline {
namespace {

/// Highest point of the drape above the side of the neck [m].
double above_neck(const std::string& garment) {
  const CaseResult result = support::only_draped(
      "[body]\nsex = 0.4\nage = 9\nheight = 1.35\n"
      "measurements = { chest = 0.64, waist = 0.57, hip = 0.68 }\n[garment]\n" +
      garment + "\n[material]\nname = \"cotton-jersey\"\n[simulation]\nedge_length = 0.03\n");
  double highest = 0;
  for (const Vec3& p : result.studied().drape.positions) highest = std::max(highest, p.z());
  return highest - result.body.body->landmarks.at("hps_L").z();
}

TEST(LooseTShirt, OfAStretchyKnitHangsFromTheShouldersOfASlimChild) {
  for (const char* garment :
       {"pattern = \"t-shirt\"\nsize = \"child-142\"",
        "pattern = \"t-shirt\"\nfit = { chest = 0.30, hip = 0.20, sleeve = 0.35, wrist = 0.35, "
        "sleeve_length = 0.42, neck_ease = 0 }"}) {
    const double above = above_neck(garment);
    EXPECT_GT(above, -0.03) << garment;
    EXPECT_LT(above, 0.02) << garment;
  }
}

}  // namespace
}  // namespace loosefit::pipeline

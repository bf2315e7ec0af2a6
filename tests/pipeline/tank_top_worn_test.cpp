#include <gtest/gtest.h>

#include <algorithm>

#include "support/only_draped.h"

namespace loosefit::pipeline {
namespace {

TEST(TankTopWorn, HangsByItsStrapsOnWomanAndChild) {
  for (const char* body : {"sex = \"female\"\n", "sex = 0.4\nage = 9\nheight = 1.35\n"}) {
    SCOPED_TRACE(body);
    const CaseResult result = support::only_draped(
        "[body]\n" + std::string(body) +
        "[garment]\npattern = \"tank-top\"\n[simulation]\nedge_length = 0.02\n");
    // The straps lie on the shoulders, beside the neck.
    const garment::Garment::EdgeChain* strap =
        result.studied().mesh().find_part("front", "shoulder_L");
    ASSERT_TRUE(strap);
    const auto& marks = result.body.body->landmarks;
    for (const int v : strap->vertices) {
      const Vec3& p = result.studied().drape.positions[v];
      EXPECT_GT(p.x(), marks.at("hps_L").x() - 0.01);
      EXPECT_LT(p.x(), marks.at("acromion_L").x() + 0.01);
      EXPECT_GT(p.z(), marks.at("acromion_L").z() - 0.03);
    }
  }
}

}  // namespace
}  // namespace loosefit::pipeline

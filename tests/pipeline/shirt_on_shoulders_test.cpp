#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "loosefit/geometry/closest_point_tree.h"
#include "support/only_draped.h"

namespace loosefit::pipeline {
namespace {

// A shirt hangs from its shoulders: it lies on them between neck and shoulder point, and its back
// neckline at the nape. Seams as steep as the shoulder looks from the front, and back necklines as
// deep as the neck is upright, stand off by 5 to 21 mm and 21 to 33 mm above the nape
// (docs/theory/patterns.md 2).
TEST(ShirtOnShoulders, LiesOnThemBetweenNeckAndShoulderPoint) {
  for (const char* body : {"sex = \"female\"\nage = 30\nheight = 1.68\n"
                           "measurements = { chest = 0.88, waist = 0.72, hip = 0.97 }\n",
                           "sex = 0.4\nage = 9\nheight = 1.35\n"}) {
    SCOPED_TRACE(body);
    const CaseResult result = support::only_draped(
        "[body]\n" + std::string(body) +
        "[garment]\npattern = \"long-sleeve-shirt\"\nfit = { chest = 0.10, hip = 0.08, sleeve = "
        "0.25 }\n[simulation]\nedge_length = 0.02\n[donning]\nmovements = []\n");
    const garment::Garment& shirt = result.studied().mesh();
    const auto& x = result.studied().drape.positions;
    const auto& marks = result.body.body->landmarks;
    const geometry::ClosestPointTree& skin = result.body.body.tree();
    for (const char* side : {"L", "R"}) {
      SCOPED_TRACE(side);
      const auto* seam = shirt.find_part("front", std::string("shoulder_") + side);
      ASSERT_TRUE(seam);
      const Vec3 neck = marks.at(std::string("hps_") + side),
                 tip = marks.at(std::string("acromion_") + side);
      double sum = 0;
      int count = 0;
      for (const int v : seam->vertices) {
        const double share = (x[v] - neck).dot(tip - neck) / (tip - neck).squaredNorm();
        if (share < 0.15 || share > 0.85) continue;
        sum += skin.signed_distance(x[v]);
        ++count;
      }
      ASSERT_GE(count, 3);
      EXPECT_LT(sum / count, 0.004);
    }
    const auto& nape = shirt.find_part("back", "neck")->vertices;
    const int middle = *std::ranges::min_element(
        nape, {}, [&](int v) { return std::abs(x[v].x() - marks.at("c7").x()); });
    EXPECT_NEAR(x[middle].z(), marks.at("c7").z(), 0.010);
  }
}

}  // namespace
}  // namespace loosefit::pipeline

#include <gtest/gtest.h>

#include <cmath>

#include "loosefit/geometry/closest_point_tree.h"
#include "support/only_draped.h"

namespace loosefit::pipeline {
namespace {

/// Mean distance of the cloth from the skin behind the waist [m].
double gap_behind_waist(const char* back_waist) {
  const CaseResult result = support::only_draped(
      std::string("[body]\nsex = \"female\"\nage = 30\nheight = 1.68\n"
                  "measurements = { chest = 0.88, waist = 0.72, hip = 0.97 }\n[garment]\n"
                  "pattern = \"long-sleeve-shirt\"\n"
                  "fit = { chest = 0.10, hip = 0.08, sleeve = 0.25, wrist = 0.25, sleeve_follow = "
                  "0, bust_dart = 0.5, "
                  "back_waist = ") +
      back_waist +
      " }\n[material]\nname = \"paper-cotton\"\n[simulation]\nedge_length = "
      "0.025\n");
  const body::PosedBody& body = result.body.body;
  const Vec3 waist = body->landmarks.at("back_waist");
  const geometry::ClosestPointTree skin(body->surface);
  double sum = 0;
  int count = 0;
  for (const Vec3& p : result.studied().drape.positions)
    if (p.y() > waist.y() - 0.08 && std::abs(p.x()) < 0.15 && std::abs(p.z() - waist.z()) < 0.06) {
      sum += skin.signed_distance(p);
      ++count;
    }
  EXPECT_GT(count, 10);
  return sum / count;
}

TEST(BackWaistWorn, LiesCloserBehindTheWaist) {
  const double straight = gap_behind_waist("0"), shaped = gap_behind_waist("0.03");
  RecordProperty("straight_mm", std::to_string(1e3 * straight));
  RecordProperty("shaped_mm", std::to_string(1e3 * shaped));
  EXPECT_LT(shaped, straight - 0.002) << straight;
}

}  // namespace
}  // namespace loosefit::pipeline

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "loosefit/drape/worn.h"
#include "support/only_draped.h"

namespace loosefit::pipeline {
namespace {

/// The hood turned about the neck to behind the shoulders.
std::vector<Vec3> with_the_hood_thrown_back(const CaseResult& result) {
  const garment::Garment& hoodie = result.studied().mesh();
  std::vector<Vec3> x = result.studied().drape.positions;
  const Vec3 axis = result.body.body->landmarks.at("c7");
  for (int v = 0; v < hoodie.vertex_count; ++v) {
    if (!hoodie.panel_names[hoodie.vertex_panel[v]].starts_with("hood")) continue;
    // As far as it stands above the neck; the seam stays.
    const double share = std::clamp((x[v].z() - axis.z()) / 0.05, 0.0, 1.0);
    const Eigen::AngleAxisd back(-share * radians(110), Vec3::UnitX());
    x[v] = axis + back * (x[v] - axis);
  }
  return x;
}

TEST(HoodieWorn, HoodIsOverTheHeadOfManAndChild) {
  for (const char* body :
       {"sex = \"male\"\nheight = 1.80\n", "sex = 0.4\nage = 9\nheight = 1.35\n"}) {
    SCOPED_TRACE(body);
    const CaseResult result =
        support::only_draped("[body]\n" + std::string(body) +
                             "[garment]\npattern = \"hoodie\"\n[simulation]\nedge_length = "
                             "0.025\n[donning]\nmovements = []\n");
    const garment::Garment& hoodie = result.studied().mesh();
    const auto& x = result.studied().drape.positions;
    const auto highest = [&](const char* part, const char* edge) {
      double z = 0;
      for (const int v : hoodie.find_part(part, edge)->vertices) z = std::max(z, x[v].z());
      return z;
    };
    // Over the crown, and the bands at the wrists and round the hips.
    const auto& marks = result.body.body->landmarks;
    const double neck = marks.at("hps_L").z();
    EXPECT_GT(highest("hood_L", "back"),
              neck + result.body.body->measured.at("hps_to_crown") - 0.02);
    const pattern::Pattern& cut = result.studied().pattern.pattern;
    EXPECT_EQ(drape::why_not_worn(hoodie, cut, x, result.body.body), std::vector<std::string>{});
    EXPECT_EQ(drape::why_not_worn(hoodie, cut, with_the_hood_thrown_back(result), result.body.body),
              std::vector<std::string>{"the hood has slid off the head"});
    EXPECT_LT(highest("hem_band_back", "rim"), marks.at("back_waist").z());
    EXPECT_LT(highest("cuff_L_front", "rim"), result.body.body->joints.at("elbow_L").z());
  }
}

TEST(HoodieWorn, OverATShirtNothingCutsAndTheHoodIsNotCaughtOnAnEar) {
  const CaseResult result = support::only_draped(
      "[body]\nsex = \"male\"\nage = 35\nheight = 1.78\n[garment]\npattern = \"hoodie\"\n"
      "[material]\nname = \"wool\"\n[[under]]\npattern = \"t-shirt\"\n[under.material]\nname = "
      "\"cotton-jersey\"\n[simulation]\nedge_length = 0.03\n[donning]\nmovements = []\n");
  ASSERT_EQ(result.garments.size(), 2u);
  // What is worn is settled, else only_draped has failed; the hood is still over the head.
  const auto& x = result.studied().drape.positions;
  double top = 0;
  for (const int v : result.studied().mesh().find_part("hood_L", "back")->vertices)
    top = std::max(top, x[v].z());
  const double neck = result.body.body->landmarks.at("hps_L").z();
  EXPECT_GT(top, neck + result.body.body->measured.at("hps_to_crown") - 0.02);
}

}  // namespace
}  // namespace loosefit::pipeline

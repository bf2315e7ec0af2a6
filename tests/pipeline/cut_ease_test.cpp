#include <fmt/format.h>
#include <gtest/gtest.h>

#include <random>

#include "loosefit/garment/hierarchy.h"
#include "loosefit/kinds/girths_along.h"
#include "loosefit/pipeline/case_ease.h"
#include "loosefit/pipeline/case_pattern.h"
#include "loosefit/pipeline/ease_on_mesh.h"
#include "support/body_fixture.h"

namespace loosefit::pipeline {
namespace {

/// People and fits that this test draws itself.
class CutEase : public ::testing::Test {
 protected:
  double draw(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  body::Body person() {
    body::BodyParameters p;
    p.sex = draw(0, 1), p.age = draw(18, 70), p.muscle = draw(0.3, 0.7), p.weight = draw(0.3, 0.8);
    p.height = draw(0.3, 0.7);
    return body_model().build(p, body::kArmsApart);
  }
  /// Greatest miss over the stations of a limb that were asked for, and how many there are.
  static std::pair<double, int> miss(const CasePattern& pattern, const std::string& limb) {
    double most = 0;
    int count = 0;
    for (const StationFit& s : pattern.fit_along)
      if (s.limb == limb && s.asked) {
        ++count;
        most = std::max(most, std::abs(s.garment / ((1 + *s.asked) * s.body) - 1));
      }
    return {most, count};
  }
  std::mt19937 random_{20261130};
};

constexpr double kWithin = 0.02;  // of the girth that was asked for

TEST_F(CutEase, OfSleeveAndTrunkIsWhatWasAskedForAtEveryStation) {
  for (int i = 0; i < 12; ++i) {
    const body::Body body = person();
    scenario::GarmentSpec spec;
    spec.kind = i % 2 ? "long-sleeve-shirt" : "t-shirt";
    const double ease = draw(-0.25, 0.3);
    for (const char* key : {"chest", "waist", "hip", "sleeve", "wrist"})
      spec.fit[key] = ease + draw(-0.04, 0.04);
    if (i % 2) spec.fit["elbow"] = ease + 0.05;
    spec.adapt = {"scye_ease", "shoulder_follow", "neck_ease", "sleeve_length"};
    const CasePattern pattern = make_pattern(spec, body, kinds::girths_along(body));
    const auto [sleeve, sleeves] = miss(pattern, "arm");
    const auto [trunk, trunks] = miss(pattern, "trunk");
    EXPECT_GE(sleeves, i % 2 ? 11 : 1);
    EXPECT_GT(trunks, 12);
    EXPECT_LT(sleeve, kWithin) << i << " " << spec.kind << " ease " << ease;
    EXPECT_LT(trunk, kWithin) << i << " " << spec.kind << " ease " << ease;
  }
}

TEST_F(CutEase, OfALegIsWhatWasAskedForFromThighToHem) {
  for (int i = 0; i < 8; ++i) {
    const body::Body body = person();
    scenario::GarmentSpec spec;
    spec.kind = "leggings";
    const double ease = draw(-0.2, 0.0);
    for (const char* key : {"hip", "thigh", "knee", "calf", "hem"}) spec.fit[key] = ease;
    spec.adapt = {"waist"};
    const CasePattern pattern = make_pattern(spec, body, kinds::girths_along(body));
    const auto [leg, stations] = miss(pattern, "leg");
    EXPECT_GT(stations, 20);
    EXPECT_LT(leg, 1.5 * kWithin) << i << " ease " << ease;  // one of eight by 2.8 %
  }
}

TEST_F(CutEase, OfAStraightSleeveIsNoLessThanAskedFor) {
  const body::Body body = person();
  scenario::GarmentSpec spec;
  spec.kind = "long-sleeve-shirt";
  spec.fit = {{"sleeve", 0.1}, {"wrist", 0.1}, {"sleeve_follow", 0}};
  const CasePattern pattern = make_pattern(spec, body, kinds::girths_along(body));
  double most = 0;
  for (const StationFit& s : pattern.fit_along)
    if (s.limb == "arm") {
      EXPECT_GT(s.cut(), 0.1 - kWithin) << s.along;
      most = std::max(most, s.cut());
    }
  EXPECT_GT(most, 0.15) << "a straight taper leaves more room somewhere";
}

TEST_F(CutEase, IsKnownAtTheVerticesOfTheMesh) {
  const body::Body body = person();
  scenario::GarmentSpec spec;
  spec.kind = "long-sleeve-shirt";
  spec.fit = {{"chest", -0.1}, {"waist", -0.1}, {"hip", -0.1}, {"sleeve", -0.1}, {"wrist", -0.1}};
  const CasePattern pattern = make_pattern(spec, body, kinds::girths_along(body));
  garment::GarmentHierarchy mesh = garment::build_hierarchy(pattern.pattern, 0.02, {});
  set_vertex_ease(mesh, pattern);
  int left = 0, right = 0;
  for (int v = 0; v < mesh.finest().vertex_count; ++v) {
    const std::string& part = mesh.finest().panel_parts[mesh.finest().vertex_panel[v]];
    if (std::isnan(mesh.finest().vertex_ease_cut[v])) continue;
    EXPECT_NEAR(mesh.finest().vertex_ease_cut[v], -0.1, kWithin) << part;
    EXPECT_NEAR(mesh.finest().vertex_ease_asked[v], -0.1, 1e-9) << part;
    left += part == "sleeve_L_front", right += part == "sleeve_R_front";
  }
  EXPECT_GT(left, 100);
  EXPECT_GT(right, 100);
}

TEST_F(CutEase, CloseSleevesAreMeshedFinerAndLooseOnesAreNot) {
  const body::Body body = person();
  for (const double ease : {-0.1, 0.2}) {
    scenario::GarmentSpec spec;
    spec.kind = "long-sleeve-shirt";
    spec.fit = {{"sleeve", ease}, {"wrist", ease}};
    const CasePattern pattern = make_pattern(spec, body, kinds::girths_along(body));
    const std::vector<double> finer = limb_fineness(pattern, 0.014);
    for (std::size_t p = 0; p < finer.size(); ++p) {
      const bool sleeve = pattern.pattern.panels[p].part.starts_with("sleeve");
      if (sleeve && ease < 0)
        EXPECT_LT(finer[p], 0.65);
      else
        EXPECT_EQ(finer[p], 1);
    }
    const garment::GarmentHierarchy coarse = garment::build_hierarchy(pattern.pattern, 0.04, {});
    EXPECT_EQ(limb_mesh_warnings(coarse.finest(), pattern).empty(), ease > 0);
    const garment::GarmentHierarchy fine =
        garment::build_hierarchy(pattern.pattern, 0.014, {}, {}, finer);
    EXPECT_TRUE(limb_mesh_warnings(fine.finest(), pattern).empty());
  }
}

}  // namespace
}  // namespace loosefit::pipeline

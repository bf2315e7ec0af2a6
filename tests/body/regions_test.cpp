#include "loosefit/body/regions.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "support/body_fixture.h"

namespace loosefit::body {
namespace {

Body woman(double sitting = 0) {
  BodyParameters p;
  p.sex = 0;
  Posture posture = kArmsApart;
  posture.sitting = sitting;
  return body_model().build(p, posture);
}

std::map<Region, int> counted(const std::vector<Region>& regions) {
  std::map<Region, int> count;
  for (Region region : regions) ++count[region];
  return count;
}

TEST(BodyRegions, LegsFollowBelowTheCrotchFromTheHipsDown) {
  const Body body = woman();
  const std::vector<Region> regions = body_regions(body);
  const double crotch = body.landmarks.at("crotch").z();
  const auto expect = [&](std::size_t v, Region left, Region right) {
    const Vec3& p = body.surface.vertices[v];
    EXPECT_EQ(regions[v], p.x() > 0 ? left : right) << p.transpose();
  };
  const double knee = body.joints.at("knee_L").z(), ankle = body.joints.at("ankle_L").z();
  for (std::size_t v = 0; v < regions.size(); ++v) {
    const Vec3& p = body.surface.vertices[v];
    const bool leg = body.segment[v] == Segment::thigh || body.segment[v] == Segment::shank ||
                     body.segment[v] == Segment::foot;
    if (!leg) continue;
    constexpr double kBorder = 0.06;  // the segment's border is not a plane [m]
    if (p.z() >= crotch) {
      expect(v, Region::hips, Region::hips);
    } else if (p.z() > knee + kBorder) {
      expect(v, Region::thigh_left, Region::thigh_right);
    } else if (p.z() < knee - kBorder && p.z() > ankle + kBorder) {
      expect(v, Region::shank_left, Region::shank_right);
    } else if (p.z() < 0.5 * ankle) {
      expect(v, Region::foot_left, Region::foot_right);
    }
  }
}

TEST(BodyRegions, EveryOneIsThereAndBothSidesAreAlike) {
  const std::map<Region, int> count = counted(body_regions(woman()));
  for (Region region : all_regions()) {
    ASSERT_TRUE(count.count(region)) << name(region);
    std::string other = name(region);
    if (other.size() < 2 || other.substr(other.size() - 2) != "_L") continue;
    other.back() = 'R';
    EXPECT_NEAR(count.at(region), count.at(*find_region(other)), 0.05 * count.at(region)) << other;
  }
}

TEST(BodyRegions, StayWithTheSkinOfASittingWearer) {
  EXPECT_EQ(body_regions(woman()), body_regions(woman(1)));
}

TEST(BodyRegions, WithoutLandmarksLevelsComeFromStature) {
  Body body = woman();
  const std::vector<Region> with = body_regions(body);
  body.landmark_vertex.clear();
  body.measured.clear();
  const std::vector<Region> without = body_regions(body);
  int other = 0;
  for (std::size_t v = 0; v < with.size(); ++v) other += with[v] != without[v];
  EXPECT_LT(other, 0.15 * static_cast<double>(with.size()));
  EXPECT_GT(other, 0) << "the body's own levels are not the mean ones";
}

TEST(BodyRegions, AreFoundByTheNamesInFiles) {
  EXPECT_EQ(region_names().size(), all_regions().size());
  for (Region region : all_regions()) EXPECT_EQ(find_region(name(region)), region);
  EXPECT_EQ(find_region("upper_sleeve_L"), Region::upper_arm_left);
  EXPECT_FALSE(find_region("sleeve"));
}

}  // namespace
}  // namespace loosefit::body

#include "loosefit/placement/sites.h"

#include <gtest/gtest.h>

#include "loosefit/base/error.h"
#include "loosefit/maps/compute_maps.h"
#include "loosefit/placement/ray.h"
#include "support/tube_garment.h"

namespace loosefit {
namespace {

constexpr double kRadius = 0.12, kTube = 0.13;

class Sites : public ::testing::Test {
 protected:
  void SetUp() override {
    body_.landmarks = {{"c7", {0, kRadius, 0.75}},
                       {"back_waist", {0, kRadius, 0.40}},
                       {"sternum", {0, -kRadius, 0.62}},
                       {"scapula_L", {0.05, 0.109, 0.66}},
                       {"crown", {0, 0, 1.0}}};
    garment_ = testing::tube_garment(2 * kPi * kTube, 0.4, 160, 80);
    drape_ = testing::settled_drape(garment_, [](const Vec2& uv) {
      const double a = uv.x() / kTube;
      return Vec3(kTube * std::cos(a), kTube * std::sin(a), 0.35 + uv.y());
    });
    worn_ = relate(garment_, drape_.positions, body_);
    maps_ = compute_maps(garment_, drape_, worn_);
  }
  std::vector<Site> find(const std::vector<SiteSpec>& wished, bool presets = false) {
    return find_sites(garment_, drape_.positions, body_, worn_, maps_, wished, presets);
  }
  Body body_ = testing::cylinder_body(kRadius, 1.0, 200, 100);
  Garment garment_;
  Drape drape_;
  WornGarment worn_;
  std::vector<PerformanceMap> maps_;
};

TEST_F(Sites, PatternPlaceIsFoundWhereItDrapes) {
  const double quarter = 2 * kPi * kTube / 4;
  const Site site = find({{"mine", "tube", {quarter, 0.1}, ""}}).at(0);
  EXPECT_NEAR((site.position - Vec3(0, kTube, 0.45)).norm(), 0, 1e-4);
  EXPECT_NEAR((site.body_point - Vec3(0, kRadius, 0.45)).norm(), 0, 6e-3);
  EXPECT_NEAR(site.values.at("distance_mm").mean, 10, 0.05);
  EXPECT_NEAR(site.values.at("angular_deviation_deg").mean, 0, 0.3);
  EXPECT_EQ(site.values.size(), 7u);
}

TEST_F(Sites, LandmarkGoesToTheClothOverIt) {
  const Site site = find({{"blade", "", {}, "scapula_L"}}).at(0);
  EXPECT_EQ(site.name, "blade");
  EXPECT_EQ(site.panel, "tube");
  EXPECT_NEAR(site.position.z(), 0.66, 1e-3);
  EXPECT_NEAR(site.at.y(), 0.31, 1e-3);
  EXPECT_NEAR(site.at.x(), kTube * std::atan2(0.109, 0.05), 1e-3);
  EXPECT_GT(site.position.y(), 0);
}

TEST_F(Sites, PresetsThatTheBodyHasAreListed) {
  std::vector<std::string> names;
  for (const Site& site : find({}, true)) names.push_back(site.name);
  EXPECT_EQ(names, (std::vector<std::string>{"scapula_L", "sternum", "heart", "ecg_L", "ecg_R",
                                             "abdomen", "waist_L", "waist_R"}));
}

TEST_F(Sites, PresetSidesAreTheWearers) {
  EXPECT_GT(site_point(body_, "waist_L").x(), 0.11);
  EXPECT_LT(site_point(body_, "waist_R").x(), -0.11);
  EXPECT_LT(site_point(body_, "abdomen").y(), -0.11);
  EXPECT_GT(site_point(body_, "heart").x(), 0);
}

TEST_F(Sites, ImpossibleSitesSayWhy) {
  const auto message = [&](const SiteSpec& spec) {
    try {
      find({spec});
    } catch (const InvalidInput& e) {
      return std::string(e.what()) + " / " + e.hint();
    }
    return std::string("no error");
  };
  EXPECT_NE(message({"a", "tub", {0.1, 0.1}, ""}).find("tube"), std::string::npos);
  EXPECT_NE(message({"b", "tube", {0.1, 0.9}, ""}).find("(0.1, 0.4) m"), std::string::npos);
  EXPECT_NE(message({"c", "", {}, "scapula_LL"}).find("scapula_L"), std::string::npos);
  EXPECT_NE(message({"d", "", {}, "crown"}).find("does not cover"), std::string::npos);
}

TEST_F(Sites, AreCheckedBeforeThereIsADrape) {
  const auto key = [this](const SiteSpec& wrong) -> std::string {
    try {
      check_sites(garment_, body_, {{"good", "tube", {0.1, 0.1}, ""}, wrong});
    } catch (const InvalidInput& error) {
      return error.place().key;
    }
    return {};
  };
  EXPECT_EQ(key({"a", "tub", {0.1, 0.1}, ""}), "site[1].panel");
  EXPECT_EQ(key({"b", "tube", {0.1, 0.9}, ""}), "site[1].at");
  EXPECT_EQ(key({"c", "", {}, "scapula_LL"}), "site[1].landmark");
  EXPECT_EQ(key({"d", "", {}, "crown"}), "");  // whether it is covered shows in the drape
}

TEST(Ray, LeavesACylinderAtItsWall) {
  const Body body = testing::cylinder_body(kRadius, 1.0, 400, 10);
  const auto hit = ray_exit(body.surface, {0.02, 0, 0.5}, Vec3(1, 0, 0));
  ASSERT_TRUE(hit);
  EXPECT_NEAR((*hit - Vec3(kRadius, 0, 0.5)).norm(), 0, 1e-5);
  EXPECT_FALSE(ray_exit(body.surface, {0.3, 0, 0.5}, Vec3(1, 0, 0)));
}

}  // namespace
}  // namespace loosefit

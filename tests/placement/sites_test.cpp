#include "loosefit/placement/sites.h"

#include <gtest/gtest.h>

#include "loosefit/base/error.h"
#include "loosefit/maps/compute_maps.h"
#include "loosefit/placement/ray.h"
#include "loosefit/placement/site_points.h"
#include "support/tube_garment.h"

namespace loosefit::placement {
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
    worn_ = maps::relate(garment_, drape_.positions, body_);
    maps_ = maps::compute_maps(garment_, drape_, worn_, maps::default_map_names(),
                               {.material = &material_});
  }
  std::vector<Site> find(const std::vector<SiteSpec>& wished, bool presets = false) {
    return find_sites(garment_, drape_.positions, body_, worn_, maps_, wished, presets);
  }
  fabric::Material material_;
  body::Body body_ = testing::cylinder_body(kRadius, 1.0, 200, 100);
  garment::Garment garment_;
  drape::Drape drape_;
  maps::WornGarment worn_;
  std::vector<maps::PerformanceMap> maps_;
};

TEST_F(Sites, PatternPlaceIsFoundWhereItDrapes) {
  const double quarter = 2 * kPi * kTube / 4;
  const Site site = find({{"mine", "tube", {quarter, 0.1}, ""}}).at(0);
  EXPECT_NEAR((site.position - Vec3(0, kTube, 0.45)).norm(), 0, 1e-4);
  EXPECT_NEAR((site.body_point - Vec3(0, kRadius, 0.45)).norm(), 0, 6e-3);
  EXPECT_NEAR(site.map_values.at("distance_mm").mean, 10, 0.05);
  EXPECT_NEAR(site.map_values.at("angular_deviation_deg").mean, 0, 0.3);
  EXPECT_EQ(site.map_values.size(), maps_.size());
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
                                             "abdomen", "waist_L", "waist_R", "chest_band"}));
}

TEST_F(Sites, PresetSidesAreTheWearers) {
  const SitePoints points(body_);
  EXPECT_GT(points.at("waist_L").x(), 0.11);
  EXPECT_LT(points.at("waist_R").x(), -0.11);
  EXPECT_LT(points.at("abdomen").y(), -0.11);
  EXPECT_GT(points.at("heart").x(), 0);
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
  EXPECT_NE(message({"d", "", {}, "crown"}).find("the nearest place that it covers is panel tube"),
            std::string::npos)
      << message({"d", "", {}, "crown"});
}

TEST_F(Sites, BothAddressesOfASiteMeanTheSamePlace) {
  body_.landmarks["acromion_L"] = {0.2, 0, 0.78};
  body_.landmarks["acromion_R"] = {-0.2, 0, 0.78};
  for (const Vec2& at : {Vec2(0.1, 0.25), Vec2(0.55, 0.31), Vec2(0.8, 0.22)}) {
    const Site there = find({{"there", "tube", at}}).at(0);
    ASSERT_TRUE(there.anatomy);
    SiteSpec spec;
    spec.name = "back";
    spec.anatomy = there.anatomy;
    const Site back = find({spec}).at(0);
    EXPECT_EQ(back.panel, "tube");
    EXPECT_LT((back.at - at).norm(), 5e-4);
    EXPECT_LT((back.anatomy->percent - there.anatomy->percent).cwiseAbs().maxCoeff(), 0.3);
  }
}

TEST_F(Sites, SkinBesideTheGarmentIsNotCovered) {
  // The tube ends at 0.35 m: 10 mm below it still counts as its hem, 40 mm do not.
  body_.landmarks["near"] = {0, -kRadius, 0.34};
  body_.landmarks["far"] = {0, -kRadius, 0.31};
  EXPECT_NEAR(find({{"near", "", {}, "near"}}).at(0).position.z(), 0.35, 1e-9);
  try {
    find({{"near", "", {}, "near"}, {"far", "", {}, "far"}});
    FAIL() << "nothing covers it";
  } catch (const InvalidInput& error) {
    EXPECT_EQ(error.place().key, "site[1].landmark");
    EXPECT_NE(error.hint().find("panel tube, at = ["), std::string::npos) << error.hint();
  }
}

// Weft runs round the tube, warp up it.
TEST_F(Sites, AShiftMovesTheSensorAlongTheCloth) {
  SiteSpec still{"still", "", {}, "scapula_L"}, moved = still;
  moved.name = "moved";
  moved.shift = {0.015, -0.020};
  const std::vector<Site> sites = find({still, moved});
  EXPECT_LT((sites[1].at - sites[0].at - moved.shift).norm(), 1e-9);
  EXPECT_EQ(sites[1].panel, "tube");
  EXPECT_NEAR(sites[1].position.z() - sites[0].position.z(), -0.020, 1e-9);
  const auto round = [](const Site& site) {
    return std::atan2(site.position.y(), site.position.x());
  };
  EXPECT_NEAR(round(sites[1]) - round(sites[0]), 0.015 / kTube, 1e-4);
  EXPECT_NEAR(sites[1].body_point.z(), sites[1].position.z(), 1e-3) << "the skin under it";
  // All that it covers lies about the place to which it was moved.
  for (const Footprint::Sample& sample : sites[1].footprint.samples) {
    const Vec2 place = pattern_place(garment_, {sample.triangle, sample.barycentric});
    EXPECT_LE((place - sites[1].at).norm(), kFootprintRadius + 1e-9);
  }
}

TEST_F(Sites, AShiftGoesOnBeyondASeam) {
  SiteSpec spec{"s", "tube", {0.005, 0.1}, ""};
  spec.shift = {-0.020, 0.010};
  const Site site = find({spec}).at(0);
  EXPECT_NEAR(site.at.x(), 2 * kPi * kTube - 0.015, 1e-9);
  EXPECT_NEAR(site.at.y(), 0.11, 1e-9);
  EXPECT_NEAR(std::atan2(site.position.y(), site.position.x()), -0.015 / kTube, 1e-4);
}

// The same tube in two pieces, the second drawn otherwise: the same cloth lies under the sensor.
TEST_F(Sites, AShiftTakesTheAxisAlongIntoAPieceThatIsDrawnOtherwise) {
  SiteSpec spec{"s", "tube", {kPi * kTube - 0.005, 0.1}, ""};
  spec.shift = {0.020, 0.010};
  spec.angle = radians(30.0);
  spec.footprint.kind = FootprintShape::Kind::rectangle;
  spec.footprint.size = {0.01, 0.05};
  const Site whole = find({spec}).at(0);
  Mat2 turned, mirrored;
  turned << 0, -1, 1, 0;
  mirrored << -1, 0, 0, 1;
  const garment::Garment tube = garment_;
  for (const Mat2& drawn : {turned, mirrored}) {
    garment_ = tube;
    garment_.panel_names.push_back("other");
    for (std::size_t t = 0; t < garment_.triangles.size(); ++t) {
      auto& uv = garment_.triangle_uv[t];
      if ((uv[0] + uv[1] + uv[2]).x() < 3 * kPi * kTube) continue;
      garment_.triangle_panel[t] = 1;
      for (Vec2& p : uv) p = drawn * p;
    }
    worn_ = maps::relate(garment_, drape_.positions, body_);
    const Site site = find({spec}).at(0);
    EXPECT_EQ(site.panel, "other");
    EXPECT_LT((site.at - drawn * whole.at).norm(), 1e-9);
    EXPECT_LT((site.position - whole.position).norm(), 1e-9);
    EXPECT_NEAR(site.angle, radians(drawn == turned ? 120.0 : -30.0), 1e-9);
    EXPECT_LT(
        (axis_in_pattern(site.segment_angle) - drawn * axis_in_pattern(whole.segment_angle)).norm(),
        1e-6);
    double covered = 0, of_whole = 0;
    Vec3 far = Vec3::Zero(), far_of_whole = Vec3::Zero();
    const auto moments = [&](const Site& of, double& area, Vec3& second) {
      for (const Footprint::Sample& sample : of.footprint.samples) {
        const Vec3 p = at(garment_, {sample.triangle, sample.barycentric}, drape_.positions);
        area += sample.area;
        second += sample.area * (p - of.position) * (p - of.position).z();
      }
    };
    moments(site, covered, far);
    moments(whole, of_whole, far_of_whole);
    EXPECT_NEAR(covered, of_whole, 0.01 * of_whole);
    EXPECT_LT((far - far_of_whole).norm(), 0.02 * far_of_whole.norm()) << "leans alike";
  }
}

TEST_F(Sites, ABoardIsNeverPassedOver) {
  SiteSpec plain{"plain", "tube", {0.1, 0.39}, ""}, board = plain;
  plain.shift = board.shift = {0, 0.05};
  board.board = SensorBoard{};
  std::vector<UncoveredSite> uncovered;
  const auto find_both = [&](const SiteSpec& a, const SiteSpec& b) {
    find_sites(garment_, drape_.positions, body_, worn_, maps_, {a, b}, false, &uncovered);
  };
  EXPECT_NO_THROW(find_both(plain, plain));
  EXPECT_EQ(uncovered.size(), 2u);
  try {
    find_both(plain, board);
    FAIL() << "nothing to sew it on";
  } catch (const InvalidInput& error) {
    EXPECT_EQ(error.place().key, "site[1].shift");
  }
}

TEST_F(Sites, ShiftedOverTheEdgeThereIsNoPlace) {
  SiteSpec spec{"s", "tube", {0.1, 0.39}, ""};
  spec.shift = {0, 0.010};
  EXPECT_NEAR(find({spec}).at(0).at.y(), 0.4, 1e-9);
  spec.shift = {0, 0.011};
  try {
    find({spec});
    FAIL() << "the tube ends at 0.4 m";
  } catch (const InvalidInput& error) {
    EXPECT_EQ(error.place().key, "site[0].shift");
    EXPECT_EQ(error.found(), "[0, 0.011], over the edge");
  }
  std::vector<UncoveredSite> uncovered;
  EXPECT_TRUE(find_sites(garment_, drape_.positions, body_, worn_, maps_, {spec}, false, &uncovered)
                  .empty());
  ASSERT_EQ(uncovered.size(), 1u);
  EXPECT_EQ(uncovered[0].why, "its shift leads over the edge of the garment");
}

TEST_F(Sites, BandsGoRoundAndKeepTheirThread) {
  SiteSpec band;
  band.name = "band";
  band.landmark = "sternum";
  band.footprint.kind = FootprintShape::Kind::girth;
  const std::vector<Site> sites = find({band});
  double length = 0;
  for (const auto& sample : sites[0].footprint.samples) length += sample.area;
  EXPECT_NEAR(length, 2 * kPi * kTube, 1e-3);
  EXPECT_NEAR(sites[0].map_values.at("distance_mm").mean, 10, 0.1);

  // Another drape of the same garment: 8 mm lower and turned by a quarter. The thread goes along.
  const drape::Drape other = testing::settled_drape(garment_, [](const Vec2& uv) {
    const double a = uv.x() / kTube + kPi / 2;
    return Vec3(kTube * std::cos(a), kTube * std::sin(a), 0.342 + uv.y());
  });
  const maps::WornGarment worn = maps::relate(garment_, other.positions, body_);
  const std::vector<Site> again = revisit_sites(sites, garment_, other.positions, body_, worn, {});
  EXPECT_EQ(again[0].at, sites[0].at);
  EXPECT_NEAR(again[0].position.z(), sites[0].position.z() - 0.008, 1e-9);
  EXPECT_NEAR(again[0].position.x(), kTube, 1e-3);  // was in front
  ASSERT_EQ(again[0].footprint.samples.size(), sites[0].footprint.samples.size());
  EXPECT_EQ(again[0].footprint.samples[5].triangle, sites[0].footprint.samples[5].triangle);
  EXPECT_TRUE(again[0].map_values.empty());
}

TEST_F(Sites, LongAxisOfTheBodyInThePattern) {
  EXPECT_NEAR(find({{"grain", "tube", {0.3, 0.2}}}).at(0).segment_angle, 0, 1e-3);
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

std::string board_error(const SiteSpec& site) {
  try {
    site_boards({{"plain", "tube", {0, 0}}, site});
  } catch (const InvalidInput& error) {
    return error.place().key;
  }
  return "accepted";
}

TEST(SiteBoards, TakeTheFootprintOfTheirSensor) {
  SiteSpec disc{"disc", "front", {0.1, 0.2}};
  disc.footprint.radius = 0.015;
  disc.board = SensorBoard{{.mass = 0.008, .bending = 2e-3, .membrane_factor = 20}};
  SiteSpec box = disc;
  box.name = "box";
  box.footprint.kind = FootprintShape::Kind::rectangle;
  box.footprint.size = {0.02, 0.04};
  box.angle = radians(30.0);
  const std::vector<garment::Attachment> boards =
      site_boards({disc, {"bare", "front", {0, 0}}, box});
  ASSERT_EQ(boards.size(), 2u);
  EXPECT_EQ(boards[0].name, "disc");
  EXPECT_EQ(boards[1].panel, "front");
  const garment::Board& round = std::get<garment::Board>(boards[0].part);
  EXPECT_EQ(round.radius, 0.015);
  EXPECT_EQ(round.mass, 0.008);
  EXPECT_EQ(round.bending, 2e-3);
  EXPECT_EQ(round.membrane_factor, 20);
  EXPECT_EQ(round.centre, Vec2(0.1, 0.2));
  const garment::Board& square = std::get<garment::Board>(boards[1].part);
  EXPECT_EQ(square.radius, 0);
  EXPECT_EQ(square.size, Vec2(0.02, 0.04));
  EXPECT_EQ(square.angle, radians(30.0));

  box.footprint.kind = FootprintShape::Kind::line;
  EXPECT_EQ(board_error(box), "site[1].footprint");
  SiteSpec shifted = disc;
  shifted.shift = {0.01, 0};
  EXPECT_EQ(board_error(shifted), "site[1].board") << "it is not there";
  disc.panel.clear();
  EXPECT_EQ(board_error(disc), "site[1].board");
}

TEST(Ray, LeavesACylinderAtItsWall) {
  const body::Body body = testing::cylinder_body(kRadius, 1.0, 400, 10);
  const auto hit = ray_exit(body.surface, {0.02, 0, 0.5}, Vec3(1, 0, 0));
  ASSERT_TRUE(hit);
  EXPECT_NEAR((*hit - Vec3(kRadius, 0, 0.5)).norm(), 0, 1e-5);
  EXPECT_FALSE(ray_exit(body.surface, {0.3, 0, 0.5}, Vec3(1, 0, 0)));
}

TEST(Ray, HitsTheTriangleItPassesAndNoOther) {
  const geometry::TriangleMesh one{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  const auto hits = ray_crossings(one, {0.5, 0.25, -2}, Vec3(0, 0, 1));
  ASSERT_EQ(hits.size(), 1u);
  EXPECT_LT((hits[0].barycentric - Vec3(0.25, 0.5, 0.25)).norm(), 1e-12);
  EXPECT_LT((hits[0].point - Vec3(0.5, 0.25, 0)).norm(), 1e-12);
  EXPECT_NEAR(hits[0].distance, 2, 1e-12);
  EXPECT_TRUE(hits[0].leaving);
  EXPECT_FALSE(ray_crossings(one, {0.5, 0.25, 2}, Vec3(0, 0, -1)).at(0).leaving);
  EXPECT_TRUE(ray_crossings(one, {0.5, 0.25, 2}, Vec3(0, 0, 1)).empty()) << "behind the origin";
  EXPECT_TRUE(ray_crossings(one, {-0.25, -0.25, -2}, Vec3(0, 0, 1)).empty());
  EXPECT_TRUE(ray_crossings(one, {0.6, 0.6, -2}, Vec3(0, 0, 1)).empty());
  EXPECT_TRUE(
      ray_crossings(one, {0.5, 0.25, -2}, Vec3(0, 0, 1), [](int) { return false; }).empty());
}

TEST_F(Sites, SkinBelowAHemThatStandsOffIsNotCovered) {
  // The lowest 60 mm stand off at a level: 50 mm below them there is no cloth over the skin.
  drape_ = testing::settled_drape(garment_, [](const Vec2& uv) {
    const double a = uv.x() / kTube, out = std::max(0.0, 0.06 - uv.y());
    return Vec3((kTube + out) * std::cos(a), (kTube + out) * std::sin(a),
                0.41 + std::max(0.0, uv.y() - 0.06));
  });
  worn_ = maps::relate(garment_, drape_.positions, body_);
  maps_ = maps::compute_maps(garment_, drape_, worn_, maps::default_map_names(),
                             {.material = &material_});
  body_.landmarks["under"] = {0, -kRadius, 0.36};
  body_.landmarks["edge"] = {0, -kRadius, 0.40};
  std::vector<UncoveredSite> uncovered;
  const std::vector<Site> sites =
      find_sites(garment_, drape_.positions, body_, worn_, maps_,
                 {{"under", "", {}, "under"}, {"edge", "", {}, "edge"}}, false, &uncovered);
  ASSERT_EQ(sites.size(), 1u);
  EXPECT_EQ(sites[0].name, "edge");
  ASSERT_EQ(uncovered.size(), 1u);
  EXPECT_EQ(uncovered[0].name, "under");
  EXPECT_FALSE(uncovered[0].preset);
  EXPECT_EQ(uncovered[0].why, "the garment ends 50 mm away from it");
}

TEST_F(Sites, ClothFarFromTheSkinCoversNone) {
  EXPECT_EQ(find({{"mine", "tube", {0.1, 0.2}}}).at(0).not_covering, "");
  for (Vec3& p : drape_.positions) p.x() += 0.3;
  worn_ = maps::relate(garment_, drape_.positions, body_);
  maps_ = maps::compute_maps(garment_, drape_, worn_, maps::default_map_names(),
                             {.material = &material_});
  EXPECT_NE(find({{"mine", "tube", {0.01, 0.2}}}).at(0).not_covering.find("310 mm off the skin"),
            std::string::npos)
      << find({{"mine", "tube", {0.01, 0.2}}}).at(0).not_covering;
}

}  // namespace
}  // namespace loosefit::placement

#include "loosefit/placement/address_garment.h"

#include <gtest/gtest.h>

#include <cmath>

#include "loosefit/base/error.h"
#include "loosefit/garment/assemble.h"
#include "loosefit/geometry/closest_point_tree.h"
#include "loosefit/placement/sites.h"
#include "support/shirt_kind.h"
#include "support/shirt_on_body.h"
#include "support/tube_garment.h"

namespace loosefit::placement {
namespace {

constexpr double kBody = 0.12, kTube = 0.135;

TEST(PatternPoint, NamesTheNearestValidPlace) {
  const garment::Garment tube = testing::tube_garment(0.4, 0.3, 40, 30);
  const GarmentPoint inner = pattern_point(tube, "tube", {0.123, 0.217});
  EXPECT_LT((pattern_place(tube, inner) - Vec2(0.123, 0.217)).norm(), 1e-12);
  const auto complaint = [&](const std::string& panel, const Vec2& at) {
    try {
      pattern_point(tube, panel, at);
    } catch (const InvalidInput& error) {
      return error.place().key + " | " + error.what() + " | " + error.hint();
    }
    return std::string("accepted");
  };
  EXPECT_EQ(complaint("tube", {0.1, 0.30005}), "accepted") << "an outline cut by its chords";
  EXPECT_NE(complaint("tube", {0.45, 0.1})
                .find("at | at: found (0.45, 0.1) m, 50 mm outside panel "
                      "tube, expected a place in it; the nearest is "
                      "(0.4, 0.1) m"),
            std::string::npos)
      << complaint("tube", {0.45, 0.1});
  EXPECT_NE(complaint("tub", {0.1, 0.1}).find("did you mean \"tube\""), std::string::npos);
  EXPECT_NE(complaint("tube", {std::nan(""), 0.1}), "accepted");
}

struct Worn {
  body::Body body = testing::cylinder_body(kBody, 1.0, 200, 100);
  garment::Garment garment;
  std::vector<Vec3> positions;
  maps::WornGarment worn;
  explicit Worn(const std::function<Vec3(const Vec2&)>& place)
      : garment(testing::tube_garment(2 * kPi * kTube, 0.4, 100, 48)) {
    positions = testing::settled_drape(garment, place).positions;
    worn = maps::relate(garment, positions, body);
  }
  GarmentOverSkin over_skin() const { return {garment, positions, body, worn}; }
};

Vec3 round_the_body(const Vec2& uv) {
  const double a = uv.x() / kTube;
  return {kTube * std::cos(a), kTube * std::sin(a), 0.3 + uv.y()};
}

TEST(GarmentOverSkin, UnderAndOverAreInverse) {
  const Worn worn(round_the_body);
  const GarmentOverSkin over_skin = worn.over_skin();
  for (double u = 0.01; u < 0.84; u += 0.11)
    for (double v = 0.02; v < 0.39; v += 0.09) {
      const GarmentPoint point = pattern_point(worn.garment, "tube", {u, v});
      const body::BodyPartner partner = over_skin.under(point);
      const Vec3 p = at(worn.garment, point, worn.positions);
      EXPECT_NEAR(partner.exact.point.head<2>().norm(), kBody, 1e-4);
      EXPECT_NEAR(partner.exact.point.z(), p.z(), 1e-6);
      const auto back = over_skin.over(partner.exact);
      ASSERT_TRUE(back.covered);
      EXPECT_LT((at(worn.garment, back.point, worn.positions) - p).norm(), 1e-3);
    }
}

TEST(GarmentOverSkin, OfAFoldTheInnermostLayerThatFacesOutCounts) {
  // A pleat that runs round: between v = 0.15 and 0.25 the cloth goes up, down and up again, the
  // three layers 4 mm apart, the middle one inside out.
  const auto pleat = [](const Vec2& uv) {
    const double a = uv.x() / kTube, v = uv.y();
    double z = v, out = 0;
    if (v > 0.20 && v <= 0.25) z = 0.40 - v, out = 0.004;
    if (v > 0.25) z = v - 0.10, out = 0.008;
    return Vec3((kTube + out) * std::cos(a), (kTube + out) * std::sin(a), 0.3 + z);
  };
  const Worn worn(pleat);
  geometry::ClosestPoint skin =
      geometry::ClosestPointTree(worn.body.surface).query(Vec3(0, -kBody, 0.475));
  const auto over = worn.over_skin().over(skin);
  ASSERT_TRUE(over.covered);
  EXPECT_NEAR(pattern_place(worn.garment, over.point).y(), 0.175, 1e-3);
}

TEST(GarmentOverSkin, FarClothDoesNotCover) {
  const Worn worn([](const Vec2& uv) {
    const double a = uv.x() / kTube;
    return Vec3(2.4 * kTube * std::cos(a), 2.4 * kTube * std::sin(a), 0.3 + uv.y());
  });
  const geometry::ClosestPoint skin =
      geometry::ClosestPointTree(worn.body.surface).query(Vec3(0, -kBody, 0.5));
  const auto over = worn.over_skin().over(skin);  // 2.4 · 135 − 120 = 204 mm away
  EXPECT_LT(over.miss, 1e-3);
  EXPECT_FALSE(over.covered);
}

TEST(AngleInPattern, IsThatOfTheImageOfTheAxis) {
  // The pattern turned by 25° on a plane, stretched by 1.3 along the weft and 0.9 along the warp.
  const garment::Garment cloth = testing::tube_garment(0.4, 0.3, 40, 30);
  const double turn = radians(25.0);
  std::vector<Vec3> flat;
  for (const Vec2& uv : cloth.vertex_uv) {
    const Vec2 p = Eigen::Rotation2Dd(turn) * Vec2(1.3 * uv.x(), 0.9 * uv.y());
    flat.emplace_back(p.x(), 0, p.y());
  }
  const std::vector<int> inner = {1000, 1001, 1002, 1003};
  // z is image of d: 1.3 d_u = sin(turn), 0.9 d_v = cos(turn).
  const double expected = std::atan2(-std::sin(turn) / 1.3, std::cos(turn) / 0.9);
  EXPECT_NEAR(angle_in_pattern(cloth, flat, inner, Vec3::UnitZ()), expected, 1e-9);
  EXPECT_TRUE(std::isnan(angle_in_pattern(cloth, flat, inner, Vec3::UnitY())));
}

TEST(GarmentOverSkin, BothAddressesAgreeOnAShirtWithinOnePercent) {
  const body::Body body = support::standing(support::adult_parameters(), 30);
  const garment::Garment shirt =
      garment::assemble(support::shirt_for(body, 0.12), 0.02, fabric::Material{});
  const std::vector<Vec3> x = support::dress_shirt(shirt, body);  // not settled: a hard case
  const maps::WornGarment worn = maps::relate(shirt, x, body);
  const GarmentOverSkin over_skin(shirt, x, body, worn);
  const BodyAddresses addresses(body);
  int tested = 0, covered = 0, within = 0;
  double worst_skin = 0;
  for (int t = 0; t < static_cast<int>(shirt.triangles.size()); t += 17) {
    const auto address = addresses.address(over_skin.under({t, Vec3::Constant(1.0 / 3)}).exact);
    ASSERT_TRUE(address);
    // Anatomical address → skin → garment → skin → anatomical address.
    const geometry::ClosestPoint skin = addresses.skin(*address);
    const auto over = over_skin.over(skin);
    ++tested;
    if (!over.covered) continue;
    ++covered;
    const auto again = addresses.address(over_skin.under(over.point).exact);
    ASSERT_TRUE(again);
    const SegmentAxes axes = *addresses.axes(address->segment, address->side);
    const double size = (axes.high - axes.low).maxCoeff();  // of the segment [m]
    const double off = (over_skin.under(over.point).exact.point - skin.point).norm() / size;
    worst_skin = std::max(worst_skin, off);
    within += off <= 0.01;
  }
  RecordProperty("tested", tested);
  RecordProperty("covered", covered);
  RecordProperty("within", within);
  RecordProperty("worst_per_mille", static_cast<int>(1000 * worst_skin));
  EXPECT_GT(tested, 100);
  EXPECT_GT(covered, 0.97 * tested);
  EXPECT_GT(within, 0.95 * covered);
}

}  // namespace
}  // namespace loosefit::placement

#include "loosefit/maps/body_load.h"

#include <gtest/gtest.h>

#include "loosefit/body/facing_skin.h"
#include "support/tube_garment.h"

namespace loosefit::maps {
namespace {

/// Two walls that face each other, `gap` apart [m]: the trunk below (z = 0, looking up), an arm
/// above it (looking down). Both 0.4 m wide.
body::Body trunk_and_arm(double gap) {
  body::Body body;
  const double h = 0.2;
  for (const double z : {0.0, gap})
    for (const Vec2& p : {Vec2(-h, -h), Vec2(h, -h), Vec2(h, h), Vec2(-h, h)}) {
      body.surface.vertices.emplace_back(p.x(), p.y(), z);
      body.normals.push_back(z == 0 ? Vec3::UnitZ() : Vec3(-Vec3::UnitZ()));
      body.segment.push_back(z == 0 ? body::Segment::torso : body::Segment::upper_arm);
      body.side.push_back(z == 0 ? 0 : 1);
    }
  body.surface.triangles = {{0, 1, 2}, {0, 2, 3}, {4, 6, 5}, {4, 7, 6}};
  return body;
}

/// Two vertices of cloth on the trunk, pressed with 2 and 3 N.
struct Scene {
  garment::Garment garment;
  drape::Drape drape;
  WornGarment worn;
  fabric::Material material;
  body::PosedBody body;

  explicit Scene(double gap) : body(trunk_and_arm(gap)) {
    garment.vertex_count = 2;
    garment.mass = 0.05;
    material.thickness = 0.0005;
    drape.positions = {{0, 0, 0.00025}, {0.05, 0, 0.0018}};
    drape.body_normal_force = {2, 3};
    worn.areas = {1, 3};
    worn.regions = {body::Region::abdomen, body::Region::upper_arm_left};
    for (const Vec3& p : drape.positions) {
      body::BodyPartner partner;
      partner.exact = body.tree().query(p);
      partner.normal = body->normals[body->surface.triangles[partner.exact.triangle][0]];
      worn.partners.push_back(partner);
      worn.distances.push_back(partner.exact.distance);
    }
  }
  BodyLoad load() const { return body_load(garment, drape, worn, body, material, 10); }
};

TEST(BodyLoad, IsTheSumOfTheForcesOverTheWeightAndToldByLimb) {
  const BodyLoad load = Scene(0.5).load();
  EXPECT_DOUBLE_EQ(load.normal_force, 5);
  EXPECT_DOUBLE_EQ(load.weight, 0.5);
  EXPECT_DOUBLE_EQ(load.force_over_weight(), 10);
  EXPECT_DOUBLE_EQ(load.of_limb.at("trunk"), 2);
  EXPECT_DOUBLE_EQ(load.of_limb.at("upper_arm_L"), 3);
  double sum = 0;
  for (const auto& [limb, force] : load.of_limb) sum += force;
  EXPECT_DOUBLE_EQ(sum, load.normal_force);
  EXPECT_EQ(load.of_limb.size(), limb_names().size());
}

TEST(BodyLoad, NearSharesAreOfTheAreaByGap) {
  // Middle surface at 0.25 and 1.8 mm: gaps of 0 and 1.55 mm on areas of 1 and 3.
  const BodyLoad load = Scene(0.5).load();
  EXPECT_DOUBLE_EQ(load.near_share[0], 0.25);
  EXPECT_DOUBLE_EQ(load.near_share[1], 0.25);
  EXPECT_DOUBLE_EQ(load.near_share[2], 1);
  EXPECT_DOUBLE_EQ(load.near_share[3], 1);
}

TEST(BodyLoad, ClothBetweenArmAndTrunkIsSqueezedWhenBothAreNear) {
  EXPECT_EQ(Scene(0.5).load().between_arm_and_trunk, 0);
  const BodyLoad half = Scene(0.002 + body::kSkinGap).load();
  EXPECT_DOUBLE_EQ(half.free_force(), 2);
  EXPECT_DOUBLE_EQ(half.free_of_limb.at("trunk"), 2);
  EXPECT_DOUBLE_EQ(half.free_of_limb.at("upper_arm_L"), 0);
  // Up to two layers and the gap of folds, 9 mm, from the arm: 0.25 and 1.8 mm less than it is off.
  EXPECT_DOUBLE_EQ(Scene(0.001 + body::kSkinGap).load().between_arm_and_trunk, 5);
  EXPECT_DOUBLE_EQ(Scene(0.002 + body::kSkinGap).load().between_arm_and_trunk, 3);
}

TEST(BodyLoad, ClothProppedInAGapNarrowerThanItsEdgesIsSqueezed) {
  Scene scene(0.012);
  EXPECT_EQ(scene.load().between_arm_and_trunk, 0);
  scene.worn.areas = {1e-4, 1e-4};
  // Mean area 2 cm²: edges of 21.5 mm; of 0.2 cm²: 6.8 mm, less than the gap of folds.
  scene.garment.triangles = {{0, 1, 0}};
  EXPECT_DOUBLE_EQ(scene.load().between_arm_and_trunk, 5);
  scene.garment.triangles.assign(10, {0, 1, 0});
  EXPECT_EQ(scene.load().between_arm_and_trunk, 0);
}

TEST(BodyLoad, SkinThatLooksTheSameWayDoesNotSqueeze) {
  Scene scene(0.5);
  body::Body flat = trunk_and_arm(0.5);
  flat.segment.assign(8, body::Segment::torso);
  flat.segment[2] = flat.segment[0] = body::Segment::upper_arm;  // beside it in the same plane
  scene.body = body::PosedBody(flat);
  EXPECT_EQ(scene.load().between_arm_and_trunk, 0);
}

TEST(BodyLoad, EveryRegionBelongsToANamedLimb) {
  for (body::Region region : body::all_regions())
    EXPECT_TRUE(std::ranges::count(limb_names(), limb_of(region))) << body::name(region);
  EXPECT_EQ(limb_of(body::Region::forearm_right), "forearm_R");
  EXPECT_EQ(limb_of(body::Region::shoulder_left), "trunk");
}

}  // namespace
}  // namespace loosefit::maps

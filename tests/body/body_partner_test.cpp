#include "loosefit/body/body_partner.h"

#include <gtest/gtest.h>

#include "loosefit/body/posed_body.h"
#include "support/tube_garment.h"

namespace loosefit::body {
namespace {

/// A torso cylinder and an arm cylinder beside it, 20 mm apart at x = 0.13.
Body torso_and_arm() {
  Body body = testing::cylinder_body(0.12, 1.0, 120, 20);
  const Body arm = testing::cylinder_body(0.05, 1.0, 120, 20);
  const int shift = static_cast<int>(body.surface.vertices.size());
  for (const Vec3& p : arm.surface.vertices)
    body.surface.vertices.push_back(p + Vec3(0.12 + 0.02 + 0.05, 0, 0));
  for (const Triangle& t : arm.surface.triangles)
    body.surface.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
  body.normals.insert(body.normals.end(), arm.normals.begin(), arm.normals.end());
  body.segment.resize(body.surface.vertices.size(), Segment::upper_arm);
  body.side.resize(body.surface.vertices.size(), 1);
  return body;
}

TEST(PartnerFinder, ATorsoPointInTheArmpitKeepsToTheTorso) {
  const Body body = torso_and_arm();
  const PosedBody posed(body);
  const PartnerFinder& finder = posed.partners();
  // 15 mm off the torso, 5 mm off the arm, cloth facing away from the torso.
  const Vec3 point(0.135, 0, 0.5);
  const BodyPartner torso = finder.find(point, Vec3(1, 0, 0), BodyPart::trunk);
  EXPECT_NEAR(torso.exact.distance, 0.015, 1e-4);
  EXPECT_NEAR(torso.normal.x(), 1, 1e-3);
  // The sleeve at the same place faces the other way and belongs to the arm.
  const BodyPartner sleeve = finder.find(point, Vec3(-1, 0, 0), BodyPart::arm_left);
  EXPECT_NEAR(sleeve.exact.distance, 0.005, 1e-4);
  EXPECT_NEAR(sleeve.normal.x(), -1, 1e-3);
}

TEST(PartnerFinder, ClothFoldedOverCountsToThePlainlyNearestPoint) {
  const Body body = testing::cylinder_body(0.12, 1.0, 120, 20);
  const PosedBody posed(body);
  const PartnerFinder& finder = posed.partners();
  const BodyPartner partner = finder.find({0.13, 0, 0.5}, Vec3(-1, 0, 0), BodyPart::trunk);
  EXPECT_NEAR(partner.exact.distance, 0.010, 1e-4);
  EXPECT_NEAR(partner.normal.x(), 1, 1e-3);
}

TEST(PartnerFinder, PanelsFindTheirPart) {
  const Body body = torso_and_arm();
  const PosedBody posed(body);
  const PartnerFinder& finder = posed.partners();
  const Vec3 left = Vec3::UnitX(), back = Vec3::UnitY();
  EXPECT_EQ(finder.part_of({{-0.13, 0, 0.5}, {0, 0.13, 0.5}, {0.25, 0, 0.5}}, {-left, back, left}),
            BodyPart::trunk);
  EXPECT_EQ(finder.part_of({{0.25, 0, 0.5}, {0.19, 0.06, 0.2}}, {left, back}), BodyPart::arm_left);
}

/// The body with other segments for the cylinder at x > 0.13.
Body with_second(Segment first, Segment second) {
  Body body = torso_and_arm();
  for (std::size_t v = 0; v < body.segment.size(); ++v) {
    const bool is_second = body.surface.vertices[v].x() > 0.13;
    body.segment[v] = is_second ? second : first;
    body.side[v] = is_second ? 1 : -1;
  }
  return body;
}

// The front of a long skirt is one panel: a vote for one leg would measure the other to that.
TEST(PartnerFinder, APanelOverBothLegsIsMeasuredToEither) {
  const Body body = with_second(Segment::shank, Segment::shank);
  const PosedBody posed(body);
  const PartnerFinder& finder = posed.partners();
  const Vec3 front = -Vec3::UnitY();
  const std::vector<Vec3> skirt = {{0, -0.13, 0.5}, {-0.05, -0.13, 0.5}, {0.19, -0.06, 0.5}};
  const BodyPart part = finder.part_of(skirt, {front, front, front});
  EXPECT_EQ(part, BodyPart::both_legs);
  for (const Vec3& p : skirt) EXPECT_LT(finder.find(p, front, part).exact.distance, 0.03);
  // Trousers: a few vertices of a leg lie nearer to the other one.
  std::vector<Vec3> leg(9, Vec3(0, -0.13, 0.5)), normals(10, front);
  leg.push_back({0.14, 0, 0.5});
  EXPECT_EQ(finder.part_of(leg, normals), BodyPart::leg_right);
}

TEST(PartnerFinder, APanelRoundTrunkAndForearmIsMeasuredToBothAndOneBesideItToTheTrunk) {
  const Body body = with_second(Segment::torso, Segment::forearm);
  const PosedBody posed(body);
  const PartnerFinder& finder = posed.partners();
  const Vec3 front = -Vec3::UnitY(), left = Vec3::UnitX();
  std::vector<Vec3> points(8, Vec3(0, -0.13, 0.5)), normals(8, front);
  points.insert(points.end(), 2, Vec3(0.19, -0.06, 0.5));  // before the forearm
  normals.insert(normals.end(), 2, front);
  const BodyPart kimono = finder.part_of(points, normals);
  EXPECT_EQ(kimono, BodyPart::trunk_and_arms);
  EXPECT_NEAR(finder.find(points.back(), front, kimono).exact.distance, 0.01, 2e-3);
  // The side of a shirt beside a hanging forearm faces it.
  points.resize(8), normals.resize(8);
  points.insert(points.end(), 2, Vec3(0.135, 0, 0.5));
  normals.insert(normals.end(), 2, left);
  EXPECT_EQ(finder.part_of(points, normals), BodyPart::trunk);
}

// The hem of a long dress is of a panel of the trunk.
TEST(PartnerFinder, ATrunkPanelIsMeasuredToTheShanksToo) {
  const Body body = with_second(Segment::torso, Segment::shank);
  const PosedBody posed(body);
  EXPECT_NEAR(
      posed.partners().find({0.19, -0.06, 0.5}, -Vec3::UnitY(), BodyPart::trunk).exact.distance,
      0.01, 2e-3);
}

TEST(PartnerFinder, ABodyWithoutThePartStillAnswers) {
  Body body = testing::cylinder_body(0.12, 1.0, 60, 10);
  body.segment.assign(body.segment.size(), Segment::head);
  const PosedBody posed(body);
  const PartnerFinder& finder = posed.partners();
  EXPECT_NEAR(finder.find({0.2, 0, 0.5}, Vec3(1, 0, 0), BodyPart::arm_right).exact.distance, 0.08,
              1e-3);
}

}  // namespace
}  // namespace loosefit::body

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
  EXPECT_EQ(finder.part_of({{-0.13, 0, 0.5}, {0, 0.13, 0.5}, {0.25, 0, 0.5}}), BodyPart::trunk);
  EXPECT_EQ(finder.part_of({{0.25, 0, 0.5}, {0.19, 0.06, 0.2}}), BodyPart::arm_left);
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

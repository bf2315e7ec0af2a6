#include <gtest/gtest.h>

#include "loosefit/body/floor_under.h"
#include "loosefit/body/lay_person.h"
#include "loosefit/body/missing_limbs.h"
#include "loosefit/body/stumps.h"
#include "loosefit/drape/drape_session.h"
#include "loosefit/garment/hierarchy.h"
#include "support/cut_scan.h"
#include "support/sewn_garments.h"
#include "support/shirt_on_body.h"

namespace loosefit::drape {
namespace {

const body::Body& woman() {
  static const body::Body body = support::standing(support::adult_parameters(), 40);
  return body;
}

/// The same skin, but nobody knows that the feet are feet: there is no floor.
body::Body without_floor() {
  body::Body body = woman();
  for (body::Segment& segment : body.segment)
    if (segment == body::Segment::foot) segment = body::Segment::shank;
  return body;
}

/// The same woman without her left foot.
body::Body on_one_foot() {
  const body::BodyModel& model = body_model();
  body::PosedPerson person;
  person.parameters = support::adult_parameters();
  const body::Posture posture{radians(40), 0, 0};
  person.rotations =
      body::posture_rotations(model.data(), model.rest(person.parameters).joints, posture);
  double floor = 0;
  for (const Vec3& p : body::lay(model, person).surface) floor = std::min(floor, p.z());
  person.place.translation() = Vec3(0, 0, -floor);
  const auto scan =
      support::cut_limb(model.build(person), support::cut_of(body::Segment::shank, 0.9), 1);
  person.parameters.stumps = std::make_shared<const body::Stumps>(
      body::lay(model, person), person.place, body::missing_limbs(model, person, scan));
  return model.build(person.parameters, posture);
}

Drape draped(const pattern::Pattern& pattern, const body::Body& body,
             fabric::Material material = {}) {
  material.bending_warp = material.bending_weft = 3e-5;
  const garment::GarmentHierarchy garment = garment::build_hierarchy(pattern, 0.04, material);
  Progress silent;
  DrapeOptions options;
  options.time_budget = 200;
  return drape_garment(
      garment, material, [&](double) { return body; }, options, silent);
}

double garment_weight(const pattern::Pattern& pattern) {
  return kGravity * garment::build_hierarchy(pattern, 0.04, fabric::Material{}).finest().mass;
}

double lowest(const Drape& drape) {
  double low = 10;
  for (const Vec3& p : drape.positions) low = std::min(low, p.z());
  return low;
}

TEST(FloorUnderCloth, ASkirtThatIsTooLongLiesOnIt) {
  const testing_support::Levels levels = testing_support::levels_of(woman());
  const double length = levels.waist_height + 0.5;
  const pattern::Pattern pattern = testing_support::skirt(levels, 0.98, 1.3, length, 2);
  const Drape on_floor = draped(pattern, woman());
  EXPECT_TRUE(on_floor.certificate.settled())
      << on_floor.certificate.stop_reason << (on_floor.unsettled ? on_floor.unsettled->why : "");
  EXPECT_GE(lowest(on_floor), 0);
  EXPECT_GT(on_floor.report.floor_force, 1e-3);
  // What the floor bears counts for no part of the skin.
  for (std::size_t i = 0; i < on_floor.positions.size(); ++i) {
    const Vec3& p = on_floor.positions[i];
    if (std::hypot(p.x(), p.y()) > 0.35) {
      EXPECT_EQ(on_floor.body_normal_force[i], 0);
    }
  }
  EXPECT_LT(on_floor.report.floor_force, garment_weight(pattern));
}

TEST(FloorUnderCloth, WhatNeverReachesItHasTheSameBitsAsWithoutIt) {
  const testing_support::Levels levels = testing_support::levels_of(woman());
  const pattern::Pattern pattern = testing_support::skirt(levels, 0.98, 1.3, 0.5, 2);
  const Drape with = draped(pattern, woman()), without = draped(pattern, without_floor());
  ASSERT_EQ(with.positions.size(), without.positions.size());
  for (std::size_t i = 0; i < with.positions.size(); ++i)
    ASSERT_EQ(with.positions[i], without.positions[i]) << i;
  EXPECT_EQ(with.certificate.residual, without.certificate.residual);
}

TEST(FloorUnderCloth, ASkirtLiesOnItRoundOneFoot) {
  const body::Body body = on_one_foot();
  ASSERT_TRUE(body.joints.contains("leg_end_L"));
  ASSERT_FALSE(body.joints.contains("leg_end_R"));
  const std::optional<double> floor = body::floor_under(body);
  ASSERT_TRUE(floor);
  const testing_support::Levels levels = testing_support::levels_of(woman());
  const pattern::Pattern pattern =
      testing_support::skirt(levels, 0.98, 1.3, levels.waist_height + 0.3, 2);
  const Drape drape = draped(pattern, body);
  EXPECT_TRUE(drape.certificate.settled())
      << drape.certificate.stop_reason << (drape.unsettled ? drape.unsettled->why : "");
  EXPECT_GE(lowest(drape), *floor);
  EXPECT_GT(drape.report.floor_force, 1e-3);
  EXPECT_LT(drape.report.floor_force, garment_weight(pattern));
}

TEST(FloorUnderCloth, TrousersThatAreTooLongLieOnIt) {
  pattern::Pattern pattern =
      testing_support::trousers(testing_support::levels_of(woman()), 0.98, 1.2);
  for (pattern::Panel& panel : pattern.panels) {
    double hem = 0;
    for (const Vec2& p : panel.vertices) hem = std::min(hem, p.y());
    for (Vec2& p : panel.vertices)
      if (p.y() == hem) p.y() -= 0.2;
  }
  const Drape drape = draped(pattern, woman());
  EXPECT_TRUE(drape.certificate.settled())
      << drape.certificate.stop_reason << (drape.unsettled ? drape.unsettled->why : "");
  EXPECT_GE(lowest(drape), 0);
  EXPECT_GT(drape.report.floor_force, 1e-3);
  EXPECT_LT(drape.report.floor_force, garment_weight(pattern));
}

}  // namespace
}  // namespace loosefit::drape

#include "loosefit/placement/site_points.h"

#include <gtest/gtest.h>

#include <array>

#include "support/body_fixture.h"

namespace loosefit::placement {
namespace {

/// Where on the leg a point lies, seen from the line between two joints.
struct OnLeg {
  double along;    ///< from the upper joint (0) to the lower one (1)
  double forward;  ///< sine of the angle from the side to the front
  double outward;  ///< away from the other leg
};

OnLeg on_leg(const body::Body& body, const std::string& upper, const std::string& lower,
             const std::string& side, const Vec3& point) {
  const Vec3 from = body.joints.at(upper + side), to = body.joints.at(lower + side);
  const Vec3 axis = (to - from).normalized(), at = point - from;
  const Vec3 away = (at - at.dot(axis) * axis).normalized();
  return {at.dot(axis) / (to - from).norm(), -away.y(), (side == "_L" ? 1 : -1) * away.x()};
}

// Upright, the wearer looks along -y.
TEST(SitePoints, MusclesOfTheLegLieWhereTheyAre) {
  for (const auto& [age, sex, weight] :
       {std::array{9.0, 0.0, 0.4}, std::array{30.0, 0.0, 0.5}, std::array{45.0, 1.0, 0.9}}) {
    body::BodyParameters person;
    person.age = age;
    person.sex = sex;
    person.weight = weight;
    const body::Body body = body_model().build(person, {});
    const SitePoints points(body);
    for (const std::string side : {"_L", "_R"}) {
      const auto thigh = [&](const char* name) {
        return on_leg(body, "hip", "knee", side, points.at(name + side));
      };
      const auto shank = [&](const char* name) {
        return on_leg(body, "knee", "ankle", side, points.at(name + side));
      };
      EXPECT_NEAR(thigh("quadriceps").along, 0.35, 0.08);
      EXPECT_GT(thigh("quadriceps").forward, 0.9);
      EXPECT_NEAR(thigh("hamstring").along, 0.55, 0.08);
      EXPECT_LT(thigh("hamstring").forward, -0.7);
      EXPECT_GT(thigh("hamstring").outward, 0.1);
      EXPECT_NEAR(thigh("knee").along, 1, 0.05);
      EXPECT_GT(thigh("knee").forward, 0.9);
      EXPECT_NEAR(shank("calf").along, 0.3, 0.08);
      EXPECT_LT(shank("calf").forward, -0.6);
      EXPECT_LT(shank("calf").outward, -0.1);
      EXPECT_NEAR(shank("tibialis").along, 0.4, 0.08);
      EXPECT_GT(shank("tibialis").forward, 0.5);
      EXPECT_GT(shank("tibialis").outward, 0.1);
    }
    const Vec3 pelvis = points.at("sacrum");
    EXPECT_NEAR(pelvis.x(), 0, 0.01);
    EXPECT_GT(pelvis.y(), body.joints.at("hip_L").y() + 0.03);
    EXPECT_NEAR(pelvis.z() - body.joints.at("hip_L").z(), 0.08, 0.05);
  }
}

}  // namespace
}  // namespace loosefit::placement

#include <gtest/gtest.h>

#include <random>

#include "loosefit/body/breath.h"
#include "loosefit/body/joint_postures.h"
#include "support/mirror_twins.h"

namespace loosefit::body {
namespace {

double aside(const Body& body, const std::string& side) {
  const Vec3 arm = body.joints.at("elbow" + side) - body.joints.at("shoulder" + side);
  return degrees(std::atan2(std::abs(arm.x()), -arm.z()));
}

BodyParameters drawn_person(std::mt19937& random) {
  std::uniform_real_distribution<double> share(0, 1);
  BodyParameters person;
  person.sex = share(random), person.age = 8 + 60 * share(random);
  person.weight = 1.6 * share(random), person.height = 0.3 + 0.4 * share(random);
  return person;
}

bool has_sides(const JointMotion& motion) {
  const Posture posture = joint_posture({{motion.name, motion.high}});
  return !(mirrored(posture) == posture);
}

TEST(MirroredPostures, MakeMirroredBodies) {
  std::mt19937 random(1);
  for (const JointMotion& first : joint_motions()) {
    if (!has_sides(first)) continue;
    SCOPED_TRACE(first.name);
    const BodyShape person = body_model().shape(drawn_person(random));
    std::vector<JointAngle> angles;
    const auto turn = [&](const JointMotion& motion) {
      // One leg goes on from where both are.
      const bool leg =
          motion.name.ends_with("hip-flexion") || motion.name.ends_with("knee-flexion");
      std::uniform_real_distribution<double> angle(motion.low, motion.high);
      angles.push_back({motion.name, (leg ? 0.5 : 1) * angle(random)});
    };
    turn(first);
    // With others, of one side or of both.
    for (const JointMotion& other : joint_motions())
      if (other.name != first.name && random() % 4 == 0) turn(other);
    const Posture posture = joint_posture(angles);
    const Body one = body_model().posed(person, posture),
               other = body_model().posed(person, mirrored(posture));
    EXPECT_LT(lopsidedness(one, other), 1e-6) << joint_posture_name(angles);
    EXPECT_LT(lopsidedness(inhaled(one, 0.05), inhaled(other, 0.05)), 1e-6)
        << joint_posture_name(angles);
  }
}

TEST(HangingArms, EachFindsRoomByItself) {
  BodyParameters woman;
  woman.sex = 0;
  const BodyShape person = body_model().shape(woman);
  const Body upright = body_model().posed(person, kStanding),
             bent = body_model().posed(person, joint_posture({{"side-bend", 20}}));
  // Leaning over to the left by 20°: the outer arm goes with the trunk, the inner one meets the
  // hip.
  EXPECT_NEAR(aside(bent, "_R"), aside(upright, "_R") + 20, 3);
  EXPECT_NEAR(aside(bent, "_L"), aside(upright, "_L"), 8);
}

}  // namespace
}  // namespace loosefit::body

#include "loosefit/body/named_postures.h"

#include <gtest/gtest.h>

#include "loosefit/base/error.h"
#include "loosefit/body/body_fit.h"
#include "support/body_fixture.h"
#include "support/mirror_twins.h"

namespace loosefit::body {
namespace {

Body in(const std::string& posture) { return body_model().build({}, named_posture(posture)); }

double turn_of_back(const Body& body) {
  const Vec3 back = body.landmarks.at("c7") - body.landmarks.at("back_waist");
  return degrees(std::atan2(-back.y(), back.z()));
}

Vec3 upper_arm(const Body& body) {
  return (body.joints.at("elbow_L") - body.joints.at("shoulder_L")).normalized();
}

Vec3 forearm(const Body& body) {
  return (body.joints.at("wrist_L") - body.joints.at("elbow_L")).normalized();
}

TEST(NamedPostures, RaisedArmsPointWhereTheyShouldAndAreStraight) {
  const Body forward = in("arms-forward"), overhead = in("arms-overhead");
  EXPECT_LT(upper_arm(forward).y(), -std::cos(radians(12)));
  EXPECT_NEAR(upper_arm(forward).z(), 0, 0.02);
  // 160° forward of arms that are 20° aside: within 28° of straight up, by hand.
  EXPECT_NEAR(upper_arm(overhead).z(), std::cos(radians(20)) * std::cos(radians(20)), 0.01);
  for (const Body* body : {&forward, &overhead})
    EXPECT_GT(upper_arm(*body).dot(forearm(*body)), std::cos(radians(1)));
  EXPECT_LT(upper_arm(in("a-pose")).dot(forearm(in("a-pose"))), std::cos(radians(30)));
}

struct Person {
  const char* name;
  double sex, age, height, chest, waist, hip;
};
constexpr Person kWoman{"woman", 0, 30, 1.68, 0.88, 0.72, 0.97},
    kMan{"man", 1, 30, 1.80, 1.00, 0.86, 1.02},
    kSlimChild{"slim child", 0.4, 10, 1.40, 0.63, 0.55, 0.68},
    kHeavyChild{"heavy child", 0.4, 10, 1.40, 0.75, 0.72, 0.80},
    kStoutWoman{"stout woman", 0, 50, 1.62, 1.15, 1.05, 1.22};

BodyParameters parameters_of(const Person& person) {
  BodySpec spec;
  spec.sex = person.sex, spec.age = person.age, spec.height = person.height;
  spec.measurements = {{"chest", person.chest}, {"waist", person.waist}, {"hip", person.hip}};
  return fit_body(body_model(), spec, BodyDetail::coarse).parameters;
}

/// Upper arm to the downward vertical in the frontal plane [deg].
double degrees_aside(const Body& body) {
  return degrees(std::atan2(upper_arm(body).x(), -upper_arm(body).z()));
}

double elbow_degrees(const Body& body) {
  return degrees(std::acos(upper_arm(body).dot(forearm(body))));
}

/// Where the skin next to a joint of the rest posture has gone.
Vec3 carried(const Body& body, const RestBody& rest, const std::string& bone) {
  const BodyData& data = body_model().data();
  const Vec3& joint = rest.joints[std::size_t(data.bones[std::size_t(data.bone(bone))].head)];
  std::size_t nearest = 0;
  for (std::size_t v = 0; v < rest.surface.vertices.size(); ++v)
    if ((rest.surface.vertices[v] - joint).norm() < (rest.surface.vertices[nearest] - joint).norm())
      nearest = v;
  return body.pose_from_rest[nearest] * joint.homogeneous();
}

/// Where the left palm looks: fingers × thumb, from the knuckles of the first and the last finger.
Vec3 palm_normal(const Body& body, const RestBody& rest) {
  const Vec3 wrist = carried(body, rest, "wrist.L"), first = carried(body, rest, "finger2-1.L"),
             last = carried(body, rest, "finger5-1.L");
  return (0.5 * (first + last) - wrist).cross(first - last).normalized();
}

TEST(NamedPostures, StandingArmsHangRelaxed) {
  for (const Person& person : {kWoman, kMan, kSlimChild, kHeavyChild}) {
    const Body body = body_model().build(parameters_of(person), named_posture("standing"));
    EXPECT_GE(degrees_aside(body), 7.9) << person.name;
    EXPECT_LE(degrees_aside(body), person.name == kHeavyChild.name ? 13 : 10) << person.name;
    EXPECT_GE(elbow_degrees(body), 10) << person.name;
    EXPECT_LE(elbow_degrees(body), 20) << person.name;
    // Seen from above the forearm points ahead of the upper arm, not aside.
    const Vec3 arm = upper_arm(body), bend = (forearm(body) - arm.dot(forearm(body)) * arm);
    EXPECT_LT(bend.normalized().y(), -0.98) << person.name;
    EXPECT_LT(std::abs(arm.y()), std::sin(radians(5))) << person.name;
  }
}

TEST(NamedPostures, PalmsOfHangingArmsFaceTheThighs) {
  for (const Person& person : {kWoman, kMan, kSlimChild, kStoutWoman}) {
    const BodyParameters parameters = parameters_of(person);
    const RestBody rest = body_model().rest(parameters);
    const Body relaxed = body_model().build(parameters, kStanding);
    EXPECT_LT(palm_normal(relaxed, rest).x(), -std::cos(radians(15))) << person.name;
    // The model's own palms look back as well.
    const Body stiff = body_model().build(parameters, named_posture("model-standing"));
    EXPECT_GT(palm_normal(stiff, rest).x(), -std::cos(radians(18))) << person.name;
  }
}

/// Least distance of the left forearm's skin, sideways, from trunk and thighs at its depth and
/// height within 10 mm [m].
double room_beside_trunk(const Body& body) {
  const auto is_trunk = [&](std::size_t v) {
    return body.segment[v] == Segment::torso || body.segment[v] == Segment::thigh;
  };
  double room = 1;
  for (std::size_t v = 0; v < body.segment.size(); ++v) {
    if (body.segment[v] != Segment::forearm || body.side[v] < 0) continue;
    const Vec3& p = body.surface.vertices[v];
    for (std::size_t w = 0; w < body.segment.size(); ++w) {
      const Vec3 way = p - body.surface.vertices[w];
      if (is_trunk(w) && std::abs(way.y()) < 0.01 && std::abs(way.z()) < 0.01)
        room = std::min(room, way.x());
    }
  }
  return room;
}

TEST(NamedPostures, StoutPeopleHoldTheirArmsFartherAside) {
  const auto standing = [](const Person& person) {
    return body_model().build(parameters_of(person), kStanding);
  };
  const Body slim = standing(kSlimChild), heavy = standing(kHeavyChild),
             stout = standing(kStoutWoman);
  EXPECT_NEAR(degrees_aside(slim), 8, 0.1);
  EXPECT_GT(degrees_aside(heavy), degrees_aside(slim) + 1);
  EXPECT_GT(degrees_aside(stout), degrees_aside(heavy) + 3);
  EXPECT_LT(degrees_aside(stout), 30);
  for (const Body* body : {&slim, &heavy, &stout}) EXPECT_GT(room_beside_trunk(*body), 0.008);
  // Nothing of it where it was not asked for.
  const Posture stiff{kStanding.arm_abduction, 0, 0};
  EXPECT_NEAR(degrees_aside(body_model().build(parameters_of(kStoutWoman), stiff)), 8, 0.1);
}

TEST(NamedPostures, ArmsAreLoweredWithoutJumps) {
  const BodyParameters parameters = parameters_of(kStoutWoman);
  double before = degrees_aside(body_model().build(parameters, kArmsApart));
  for (int k = 1; k <= 16; ++k) {
    const double now =
        degrees_aside(body_model().build(parameters, blend(kArmsApart, kStanding, k / 16.0)));
    EXPECT_LT(now, before + 1) << k << ": straightening elbows need a little more room";
    EXPECT_GT(now, before - 4) << k;
    before = now;
  }
}

TEST(NamedPostures, BendsLeanTheBackAndLetTheArmsHang) {
  const double upright = turn_of_back(in("standing"));
  for (const double lean : {15.0, 30.0, 45.0}) {
    const Body body = in("forward-bend-" + std::to_string(static_cast<int>(lean)));
    EXPECT_NEAR(turn_of_back(body) - upright, lean, 2) << lean;
    EXPECT_NEAR(upper_arm(body).y(), upper_arm(in("standing")).y(), 0.1) << lean;
    EXPECT_NEAR(forearm(body).y(), forearm(in("standing")).y(), 0.1) << lean;
  }
}

TEST(NamedPostures, ASlouchRoundsTheBackAndLowersTheHead) {
  const Body upright = in("standing"), slumped = in("slouch");
  EXPECT_GT(turn_of_back(slumped) - turn_of_back(upright), 10);
  EXPECT_LT(slumped.landmarks.at("c7").z(), upright.landmarks.at("c7").z() - 0.02);
}

TEST(NamedPostures, LegsWalkClimbAndSquat) {
  const auto thigh = [](const Body& b, const std::string& side) -> Vec3 {
    return (b.joints.at("knee_" + side) - b.joints.at("hip_" + side)).normalized();
  };
  const Body stride = in("stride"), stair = in("stair-climb"), squat = in("squat");
  EXPECT_LT(thigh(stride, "L").y(), thigh(stride, "R").y() - 0.5);  // 35° between them
  EXPECT_LT(stride.joints.at("ankle_L").y(), stride.joints.at("ankle_R").y() - 0.2);
  // The foot is about a step of stairs, some 17 cm and more, above the other.
  EXPECT_GT(stair.joints.at("ankle_L").z(), stair.joints.at("ankle_R").z() + 0.17);
  EXPECT_NEAR(thigh(squat, "L").z(), 0, 0.2);  // level
  EXPECT_LT(squat.joints.at("hip_L").z(), 0.6 * in("standing").joints.at("hip_L").z());
}

TEST(NamedPostures, AreMirrorSymmetricUnlessTheLegsDiffer) {
  for (const auto& [name, posture] : named_postures()) {
    if (!(mirrored(posture) == posture)) continue;
    const Body body = body_model().build({}, posture);
    for (const char* joint : {"shoulder", "elbow", "wrist"}) {
      const Vec3 l = body.joints.at(std::string(joint) + "_L"),
                 r = body.joints.at(std::string(joint) + "_R");
      EXPECT_LT((Vec3(-r.x(), r.y(), r.z()) - l).norm(), 1e-9) << name << " " << joint;
    }
  }
}

TEST(NamedPostures, AnUnknownNameIsToldTheNearest) {
  try {
    named_posture("arms-foward");
    FAIL();
  } catch (const InvalidInput& error) {
    EXPECT_NE(error.hint().find("arms-forward"), std::string::npos) << error.hint();
  }
  Posture posture;
  posture.slouch = 1.5;
  EXPECT_THROW(body_model().build({}, posture), InvalidInput);
  posture.slouch = 0, posture.arm_flexion = radians(200);
  EXPECT_THROW(body_model().build({}, posture), InvalidInput);
}

TEST(NamedPostures, BlendGoesHalfWayInEveryAngle) {
  const Posture half = blend(named_posture("standing"), named_posture("arms-overhead"), 0.5);
  EXPECT_DOUBLE_EQ(degrees(half.arm_flexion), 80);
  EXPECT_DOUBLE_EQ(degrees(half.arm_abduction), 14);
  EXPECT_DOUBLE_EQ(half.elbow_extension, 0.83);
  EXPECT_DOUBLE_EQ(half.relaxed_arms, 0.5);
  EXPECT_EQ(default_dress_posture(named_posture("arms-forward")).arm_flexion, 0);
  EXPECT_EQ(default_dress_posture(named_posture("slouch")).slouch, 0);
}

TEST(NamedPostures, GarmentsArePutOnWithTheArmsApartUnlessThatIsHowTheyAreWorn) {
  EXPECT_EQ(default_dress_posture(kStanding), kArmsApart);
  EXPECT_EQ(default_dress_posture(named_posture("model-standing")), kArmsApart);
  EXPECT_EQ(default_dress_posture(kArmsWide), kArmsWide);
}

}  // namespace
}  // namespace loosefit::body

#include "loosefit/body/missing_limbs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "loosefit/body/lay_person.h"
#include "loosefit/body/stumps.h"
#include "support/cut_scan.h"
#include "support/scanned_twin.h"

// What a scan lacks of the person of the model who stands there.
namespace loosefit::body {
namespace {

using support::cut_limb;
using support::cut_of;

struct Standing {
  PosedPerson person;
  Body body;
};

Standing standing(const BodyParameters& parameters, const Posture& posture) {
  const RestBody rest = body_model().rest(parameters);
  Standing one;
  one.person.parameters = parameters;
  one.person.rotations = posture_rotations(body_model().data(), rest.joints, posture);
  const LaidSkin laid = lay(body_model(), one.person);
  double floor = 0;
  for (const Vec3& p : laid.surface) floor = std::min(floor, p.z());
  one.person.place.translation() = Vec3(0, 0, -floor);
  one.body = body_model().build(one.person);
  return one;
}

std::vector<BodyParameters> people() {
  return {support::person(0, 30, 1.66, 0.94, 0.78, 1.00),
          support::person(1, 40, 1.78, 1.02, 0.90, 1.02),
          support::person(0, 6, 1.15, 0.58, 0.54, 0.60)};
}

const std::vector<Posture>& stances() {
  static const std::vector<Posture> kStances = {
      {radians(85), 0, 0, 0, 0.9}, {radians(40), 0, 0}, kStanding};
  return kStances;
}

std::vector<std::string> names(const std::vector<MissingLimb>& missing) {
  std::vector<std::string> found;
  for (const MissingLimb& limb : missing) found.push_back(limb.name());
  return found;
}

TEST(MissingLimbs, AreNamedWhereverALimbIsCut) {
  std::mt19937 draw(7);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(draw);
  };
  struct Case {
    Segment in;
    double low, high;
    const char* name;
  };
  const Case cases[] = {{Segment::upper_arm, 0.20, 0.45, "arm"},
                        {Segment::upper_arm, 0.60, 0.95, "forearm and hand"},
                        {Segment::forearm, 0.05, 0.40, "forearm and hand"},
                        {Segment::forearm, 0.60, 0.95, "hand"},
                        {Segment::thigh, 0.35, 0.45, "leg"},
                        {Segment::thigh, 0.60, 0.95, "shank and foot"},
                        {Segment::shank, 0.05, 0.40, "shank and foot"},
                        {Segment::shank, 0.60, 0.95, "foot"}};
  int person = 0;
  for (const BodyParameters& parameters : people()) {
    const Standing one = standing(parameters, stances()[std::size_t(person++)]);
    for (const Case& c : cases)
      for (const int side : {1, -1}) {
        const double share = between(c.low, c.high);
        const auto scan = cut_limb(one.body, cut_of(c.in, share), side);
        const auto missing = missing_limbs(body_model(), one.person, scan);
        const std::string name = (side > 0 ? "left " : "right ") + std::string(c.name);
        ASSERT_EQ(names(missing), std::vector<std::string>{name}) << share;
        EXPECT_GT(missing[0].beyond, 0.05) << name;
        const support::LimbCut cut = cut_of(c.in, share);
        const std::string end = side > 0 ? "_L" : "_R";
        const Vec3 from = one.body.joints.at(cut.from + end);
        const Vec3 at = from + share * (one.body.joints.at(cut.to + end) - from);
        EXPECT_LT((missing[0].end - at).norm(), 0.03) << name << " " << share;
      }
  }
}

TEST(MissingLimbs, HeadAndBothArmsOfATrunkAreNamed) {
  const Standing one = standing(people()[0], stances()[1]);
  const auto scan = support::without_segments(
      one.body,
      {Segment::head, Segment::neck, Segment::upper_arm, Segment::forearm, Segment::hand});
  EXPECT_EQ(names(missing_limbs(body_model(), one.person, scan)),
            (std::vector<std::string>{"left arm", "right arm", "head"}));
}

// Somebody whose legs both end at the ankles, laid on by a shorter person who stands on the floor.
TEST(MissingLimbs, FeetThatBothLegsLackAreNamed) {
  Standing one = standing(people()[0], stances()[1]);
  geometry::TriangleMesh scan = support::without_segments(one.body, {Segment::foot});
  const double ankle = one.body.joints.at("ankle_L").z();
  for (Vec3& p : scan.vertices)
    if (p.z() < 2 * ankle) p.z() = 2 * (p.z() - ankle) + 0.01;
  EXPECT_EQ(names(missing_limbs(body_model(), one.person, scan)),
            (std::vector<std::string>{"left foot", "right foot"}));
}

TEST(MissingLimbs, WholePeopleLackNothing) {
  for (const BodyParameters& parameters : people())
    for (const Posture& posture : stances()) {
      const Standing one = standing(parameters, posture);
      EXPECT_EQ(names(missing_limbs(body_model(), one.person, one.body.surface)),
                std::vector<std::string>{});
      EXPECT_EQ(names(doubtful_limbs(body_model(), one.person, one.body.surface)),
                std::vector<std::string>{});
    }
}

// Shoes, a bun of hair, and closed hands are no missing limbs; nor are holes.
TEST(MissingLimbs, WhatReachesFartherOrIsClosedIsNotMissing) {
  const Standing one = standing(people()[1], stances()[1]);
  geometry::TriangleMesh scan = one.body.surface;
  const double top = one.body.measured.at("height");
  for (std::size_t v = 0; v < scan.vertices.size(); ++v) {
    Vec3& p = scan.vertices[v];
    if (one.body.segment[v] == Segment::foot) p += 0.02 * one.body.normals[v];
    if (p.z() > top - 0.06) p.z() += 0.08 * (p.z() - top + 0.06) / 0.06;
    if (one.body.segment[v] == Segment::hand) {  // fingers drawn in
      const Vec3 wrist = one.body.joints.at(one.body.side[v] > 0 ? "wrist_L" : "wrist_R");
      const double reach = (p - wrist).norm();
      if (reach > 0.08) p = wrist + 0.08 / reach * (p - wrist);
    }
  }
  std::erase_if(scan.triangles, [&](const Triangle& t) {
    return (scan.vertices[std::size_t(t[0])] - one.body.joints.at("elbow_L")).norm() < 0.05 ||
           (scan.vertices[std::size_t(t[0])] - one.body.joints.at("ankle_R")).norm() < 0.05;
  });
  EXPECT_EQ(names(missing_limbs(body_model(), one.person, scan)), std::vector<std::string>{});
}

TEST(Stumps, AreClosedAndTheSameInEveryPosture) {
  std::mt19937 draw(11);
  for (const Segment in : {Segment::upper_arm, Segment::forearm, Segment::thigh, Segment::shank})
    for (const int side : {1, -1}) {
      Standing one = standing(people()[std::size_t(side + 1) / 2], stances()[1]);
      const double share = std::uniform_real_distribution<double>(0.4, 0.9)(draw);
      const auto scan = cut_limb(one.body, cut_of(in, share), side);
      const auto missing = missing_limbs(body_model(), one.person, scan);
      ASSERT_EQ(missing.size(), 1u);
      BodyParameters lacking = one.person.parameters;
      lacking.stumps =
          std::make_shared<const Stumps>(lay(body_model(), one.person), one.person.place, missing);
      const std::string end =
          std::string(missing[0].of_leg() ? "leg_end" : "arm_end") + (side > 0 ? "_L" : "_R");
      Body first;
      for (const Posture& posture : {kArmsApart, kStanding, Posture{radians(70), 0, 0}}) {
        const Body body = body_model().build(lacking, posture);
        EXPECT_EQ(inspect_edges(body.surface).open, 0);
        EXPECT_EQ(connected_pieces(body.surface).size(), 1u);
        EXPECT_EQ(body.segment.size(), body.surface.vertices.size());
        EXPECT_EQ(body.pose_from_rest.size(), body.surface.vertices.size());
        const auto alone = body_model().vertices(body_model().shape(lacking), posture);
        ASSERT_EQ(alone.size(), body.surface.vertices.size());
        for (std::size_t v = 0; v < alone.size(); ++v)
          ASSERT_LT((alone[v] - body.surface.vertices[v]).norm(), 1e-12);
        ASSERT_TRUE(body.joints.count(end));
        for (const auto& [name, v] : body.landmark_vertex)
          EXPECT_EQ(body.landmarks.at(name), body.surface.vertices[std::size_t(v)]) << name;
        if (first.surface.triangles.empty()) first = body;
        EXPECT_EQ(body.surface.triangles, first.surface.triangles);
      }
      const Body whole = body_model().build(one.person.parameters, kArmsApart);
      EXPECT_LT(first.measured.at("volume"), whole.measured.at("volume") - 1e-4);
      EXPECT_NEAR(first.measured.at("volume"), geometry::enclosed_volume(scan), 0.0006);
      EXPECT_NEAR(first.measured.at("chest"), whole.measured.at("chest"), 1e-9);
      EXPECT_NEAR(first.measured.at("wrist"), whole.measured.at("wrist"), 1e-9)
          << "the other side's";
    }
}

TEST(Stumps, WhatBothSidesLackIsNotMeasured) {
  Standing one = standing(people()[0], stances()[1]);
  const auto scan = support::without_segments(one.body, {Segment::forearm, Segment::hand});
  const auto missing = missing_limbs(body_model(), one.person, scan);
  ASSERT_EQ(missing.size(), 2u);
  BodyParameters lacking = one.person.parameters;
  lacking.stumps =
      std::make_shared<const Stumps>(lay(body_model(), one.person), one.person.place, missing);
  const Body body = body_model().build(lacking, kArmsApart);
  for (const char* name : {"wrist", "forearm", "elbow", "arm_length"})
    EXPECT_FALSE(body.measured.count(name)) << name;
  for (const char* name : {"upper_arm", "chest", "height", "shoulder_breadth"})
    EXPECT_TRUE(body.measured.count(name)) << name;
  EXPECT_TRUE(is_beyond_end(body.joints, "wrist_L"));
  EXPECT_FALSE(is_beyond_end(body.joints, "shoulder_L"));
  EXPECT_FALSE(is_beyond_end(body.joints, "knee_R"));
}

}  // namespace
}  // namespace loosefit::body

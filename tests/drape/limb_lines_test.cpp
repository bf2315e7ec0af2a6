#include "loosefit/drape/limb_lines.h"

#include <gtest/gtest.h>

#include "loosefit/geometry/mesh_topology.h"
#include "support/tube_garment.h"

namespace loosefit::drape {
namespace {

/// Arms along x, 0.6 m to either side of an upright trunk.
body::Body stick_figure() {
  body::Body body;
  body.joints = {{"neck", {0, 0, 1.4}}, {"hip_L", {0.1, 0, 0.9}}, {"hip_R", {-0.1, 0, 0.9}}};
  for (const auto& [side, sign] : {std::pair(std::string("_L"), 1.0), {std::string("_R"), -1.0}}) {
    body.joints["shoulder" + side] = Vec3(0.2 * sign, 0, 1.35);
    body.joints["elbow" + side] = Vec3(0.4 * sign, 0, 1.35);
    body.joints["wrist" + side] = Vec3(0.6 * sign, 0, 1.35);
    body.joints["knee" + side] = Vec3(0.1 * sign, 0, 0.5);
    body.joints["ankle" + side] = Vec3(0.1 * sign, 0, 0.1);
  }
  return body;
}

/// Of each opening of a tube on the stick figure.
std::vector<LimbNumbers> numbers(const garment::Garment& tube, const std::vector<Vec3>& x) {
  std::vector<LimbNumbers> all;
  for (const std::vector<int>& loop : geometry::MeshTopology(tube.triangles).boundary_loops())
    all.push_back(limbs_through_openings(loop, x, limb_lines(stick_figure())));
  return all;
}

/// A sleeve of 10 cm on the left arm, moved by `shift`.
std::vector<LimbNumbers> sleeve(const Vec3& shift) {
  const garment::Garment tube = testing::tube_garment(0.3, 0.1, 12, 4);
  std::vector<Vec3> x;
  for (const Vec2& p : tube.vertex_uv) {
    const double a = 2 * kPi * p.x() / 0.3;
    x.push_back(Vec3(0.45 + p.y(), 0.05 * std::cos(a), 1.35 + 0.05 * std::sin(a)) + shift);
  }
  return numbers(tube, x);
}

TEST(LimbLines, TellWhichLimbGoesThroughWhichOpening) {
  const std::vector<LimbNumbers> both(2, round_limb(kLeftArm));
  EXPECT_EQ(sleeve(Vec3::Zero()), both) << "in at one, out at the other";
}

TEST(LimbLines, DoNotChangeWhileTheSleeveSlidesAlongTheArm) {
  EXPECT_EQ(sleeve(Vec3(-0.1, 0, 0.02)), sleeve(Vec3::Zero()));
}

TEST(LimbLines, ChangeWhenTheArmHasLeftTheSleeve) {
  EXPECT_EQ(sleeve(Vec3(0, 0, -0.2)), std::vector<LimbNumbers>(2, kRoundNothing))
      << "hangs empty below";
  EXPECT_EQ(sleeve(Vec3(0.5, 0, 0)), std::vector<LimbNumbers>(2, kRoundNothing))
      << "slid off the hand";
}

/// A collar round the neck, 2 cm high, from height z.
std::vector<LimbNumbers> collar(double z) {
  const garment::Garment tube = testing::tube_garment(0.4, 0.02, 12, 1);
  std::vector<Vec3> x;
  for (const Vec2& p : tube.vertex_uv) {
    const double a = 2 * kPi * p.x() / 0.4;
    x.emplace_back(0.064 * std::cos(a), 0.064 * std::sin(a), z + p.y());
  }
  return numbers(tube, x);
}

TEST(LimbLines, DoNotChangeWhenANecklineSlipsPastTheJointOfTheNeck) {
  EXPECT_EQ(collar(1.37), collar(1.41));
  EXPECT_EQ(collar(1.37), std::vector<LimbNumbers>(2, kRoundNeck));
}

/// A wide ring round an upright axis, at height z.
LimbNumbers ring(double z, double radius, double x = 0) {
  std::vector<Vec3> points;
  std::vector<int> loop;
  for (int i = 0; i < 24; ++i) {
    const double a = 2 * kPi * i / 24;
    points.emplace_back(x + radius * std::cos(a), radius * std::sin(a), z);
    loop.push_back(i);
  }
  return limbs_through_openings(loop, points, limb_lines(stick_figure()));
}

TEST(LimbLines, ARingBelowBothShouldersGoesRoundTheTrunkWhateverItWasMadeFor) {
  EXPECT_EQ(ring(1.3, 0.3), kRoundTrunk);
  EXPECT_EQ(ring(1.0, 0.2), kRoundTrunk);
  EXPECT_EQ(ring(0.3, 0.2), kRoundTrunk) << "round both legs";
  EXPECT_EQ(ring(-0.3, 0.3), kRoundTrunk) << "round both feet, below the soles";
  EXPECT_EQ(ring(0.3, 0.05, 0.1), round_limb(kLeftLeg));
  EXPECT_EQ(ring(1.5, 0.3), kRoundNeck);
  EXPECT_EQ(ring(2.4, 0.3), kRoundNothing) << "above the head";
}

TEST(LimbLines, ANecklineOverOneShoulderHasThatArmToo) {
  std::vector<Vec3> points;
  std::vector<int> loop;
  for (int i = 0; i < 24; ++i) {
    const double a = 2 * kPi * i / 24, x = 0.15 + 0.2 * std::cos(a);
    points.emplace_back(x, 0.15 * std::sin(a), 1.39 - 0.3 * x);
    loop.push_back(i);
  }
  EXPECT_EQ(limbs_through_openings(loop, points, limb_lines(stick_figure())),
            (LimbNumbers{1, 1, 0, 0, 0}));
}

TEST(LimbLines, AnArmReachesToTheFingertips) {
  body::Body body = stick_figure();
  const auto tip = [&] { return limb_lines(body)[kLeftArm].back(); };
  EXPECT_NEAR(tip().x(), 0.76, 1e-9) << "a hand is most of a forearm long";
  body.joints["hand_L"] = Vec3(0.6, 0, 1.27);
  EXPECT_NEAR((tip() - Vec3(0.6, 0, 1.19)).norm(), 0, 1e-9) << "bent down, joint in the palm";
  body.joints["hand_L"] = Vec3(0.6, 0, 1.15);
  EXPECT_NEAR((tip() - Vec3(0.6, 0, 1.15)).norm(), 0, 1e-9) << "as long as it is";
}

/// What a ring of 10 cm round the left arm goes round, at x, of somebody whose arm ends at `end`.
LimbNumbers round_stump(double x, double end) {
  body::Body body = stick_figure();
  body.joints["arm_end_L"] = Vec3(end, 0, 1.35);
  std::vector<Vec3> at;
  std::vector<int> loop;
  for (int i = 0; i < 12; ++i) {
    loop.push_back(i);
    at.emplace_back(x, 0.05 * std::cos(kPi * i / 6), 1.35 + 0.05 * std::sin(kPi * i / 6));
  }
  return limbs_through_openings(loop, at, limb_lines(body));
}

TEST(LimbLines, EndWhereALimbDoes) {
  for (const double end : {0.24, 0.31, 0.39, 0.41, 0.52, 0.59, 0.61}) {
    for (double x = 0.21; x < end; x += 0.007)
      EXPECT_EQ(round_stump(x, end), round_limb(kLeftArm)) << x << " of " << end;
    for (double x = end + 0.03; x < 0.8; x += 0.03)
      EXPECT_EQ(round_stump(x, end), kRoundNothing) << x << " of " << end;
  }
  body::Body body = stick_figure();
  EXPECT_FALSE(lacks_end(kLeftArm, body));
  body.joints["leg_end_R"] = Vec3(-0.1, 0, 0.4);
  EXPECT_TRUE(lacks_end(kRightLeg, body));
  EXPECT_FALSE(lacks_end(kLeftLeg, body));
  EXPECT_EQ(limb_lines(body)[kRightLeg].size(), 5u) << "chest, hips, hip, knee, end";
}

TEST(LimbLines, AreNotKnownWithoutJoints) {
  for (const std::vector<Vec3>& line : limb_lines(body::Body{})) EXPECT_TRUE(line.empty());
}

}  // namespace
}  // namespace loosefit::drape

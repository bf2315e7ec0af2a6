#include "loosefit/body/scan_frame.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "loosefit/base/error.h"
#include "loosefit/body/body_fit.h"
#include "support/body_fixture.h"

namespace loosefit::body {
namespace {

/// Angle of the line through the shoulders to x, in our frame [degrees].
double askew(const geometry::TriangleMesh& mesh, const Body& known) {
  const Vec3 across = mesh.vertices[known.landmark_vertex.at("acromion_L")] -
                      mesh.vertices[known.landmark_vertex.at("acromion_R")];
  return degrees(std::atan2(across.y(), across.x()));
}

TEST(ScanFrame, PersonsWhoStandAskewAreTurned) {
  const BodyParameters parameters = fit_body(body_model(), {}).parameters;
  for (const double arms : {20.0, 45.0, 90.0}) {
    const Body known = body_model().build(parameters, {radians(arms), 0, 0});
    for (const double turn : {15.0, 25.0, -40.0, 60.0, -75.0, 120.0, 200.0}) {
      geometry::TriangleMesh mesh = known.surface;
      const Mat3 rotation = Eigen::AngleAxisd(radians(turn), Vec3::UnitZ()).toRotationMatrix();
      for (Vec3& p : mesh.vertices) p = rotation * p + Vec3(0.3, -0.7, 0.1);
      std::vector<std::string> warnings;
      stand_in_our_frame(mesh, {"scan.obj", "m", "z"}, warnings);
      EXPECT_NEAR(askew(mesh, known), 0, 1) << arms << ' ' << turn;
      EXPECT_FALSE(warnings.empty()) << turn;
    }
  }
}

// One arm alone draws the whole aside.
TEST(ScanFrame, AMissingArmTurnsNobody) {
  struct Person {
    double sex, chest, waist, hip;
  };
  for (const Person& p : {Person{0, 0.94, 0.78, 1.00}, Person{1, 1.02, 0.90, 1.02}}) {
    BodySpec spec;
    spec.sex = p.sex;
    spec.measurements = {{"chest", p.chest}, {"waist", p.waist}, {"hip", p.hip}};
    const BodyParameters parameters = fit_body(body_model(), spec).parameters;
    Posture forward;
    forward.arm_flexion = radians(70);
    for (const Posture& posture : {Posture{radians(30), 0, 0}, forward})
      for (const int side : {1, -1}) {
        const Body known = body_model().build(parameters, posture);
        std::vector<char> gone(known.segment.size(), 0);
        for (std::size_t v = 0; v < gone.size(); ++v)
          gone[v] = known.side[v] == side &&
                    (known.segment[v] == Segment::upper_arm ||
                     known.segment[v] == Segment::forearm || known.segment[v] == Segment::hand);
        geometry::TriangleMesh mesh = known.surface;
        std::erase_if(mesh.triangles, [&](const Triangle& t) {
          return gone[std::size_t(t[0])] || gone[std::size_t(t[1])] || gone[std::size_t(t[2])];
        });
        std::vector<std::string> warnings;
        stand_in_our_frame(mesh, {"scan.obj", "m", "z"}, warnings);
        EXPECT_NEAR(askew(mesh, known), 0, 1) << p.sex << ' ' << side;
        EXPECT_EQ(warnings, std::vector<std::string>{}) << p.sex << ' ' << side;
      }
  }
}

TEST(ScanFrame, PersonsWhoStandStraightStayAsTheyAre) {
  const Body known = body_model().build(fit_body(body_model(), {}).parameters, {radians(30), 0, 0});
  geometry::TriangleMesh mesh = known.surface;
  std::vector<std::string> warnings;
  const RigidMotion motion = stand_in_our_frame(mesh, {"scan.obj", "m", "z"}, warnings);
  EXPECT_EQ(motion.linear(), Mat3::Identity());
  EXPECT_TRUE(warnings.empty());
}

// 66 in, said to be cm: nobody is refused who may be a small child, but it is told.
TEST(ScanFrame, AStatedUnitThatMakesFewPeopleIsTold) {
  const Body known = body_model().build(fit_body(body_model(), {}).parameters, {radians(30), 0, 0});
  const double tall = known.measured.at("height");
  geometry::TriangleMesh mesh = known.surface;
  for (Vec3& p : mesh.vertices) p *= 66 / tall;
  std::vector<std::string> warnings;
  stand_in_our_frame(mesh, {"scan.obj", "cm", "z"}, warnings);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_NE(warnings[0].find("a height of 0.66 m is that of few people"), std::string::npos)
      << warnings[0];
  EXPECT_NE(warnings[0].find("1.68 m if these are in"), std::string::npos) << warnings[0];
}

TEST(ScanFrame, StatedUnitsAreBelievedAsFarAsAnybodyEverStood) {
  const Body known = body_model().build(fit_body(body_model(), {}).parameters, {radians(30), 0, 0});
  EXPECT_FALSE(metres_of("ft"));
  for (const char* unit : {"m", "cm", "mm", "in"})
    for (const double stature : {0.98 * kShortestPerson, 1.02 * kShortestPerson,
                                 0.98 * kTallestPerson, 1.02 * kTallestPerson}) {
      geometry::TriangleMesh mesh = known.surface;
      for (Vec3& p : mesh.vertices)
        p *= stature / known.measured.at("height") / metres_of(unit).value();
      std::vector<std::string> warnings;
      const auto stand = [&] { stand_in_our_frame(mesh, {"scan.obj", unit, "z"}, warnings); };
      if (stature > kShortestPerson && stature < kTallestPerson)
        EXPECT_NO_THROW(stand()) << stature << ' ' << unit;
      else
        EXPECT_THROW(stand(), InvalidInput) << stature << ' ' << unit;
    }
}

}  // namespace
}  // namespace loosefit::body

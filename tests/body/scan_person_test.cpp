#include "loosefit/body/scan_person.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "loosefit/base/error.h"
#include "loosefit/body/body_check.h"
#include "loosefit/geometry/closest_point_tree.h"
#include "support/scanned_twin.h"
#include "support/shapes.h"

namespace loosefit::body {
namespace {

using support::kTape;
using support::person;

constexpr double kSkin = 0.001;  ///< 95th percentile of a noiseless scan's distance [m]

geometry::TriangleMesh as_scan(const Body& body) { return support::as_scan(body.surface); }

/// The world of as_scan in metres with z up, as from_world takes it.
Vec3 in_world(const Vec3& p) { return p + Vec3(0.31, 0.12, 0.07); }

struct Stance {
  const char* name;
  Posture posture;
};
const std::vector<Stance>& stances() {
  static const std::vector<Stance> kStances = {
      {"T-pose", {radians(85), 0, 0, 0, 0.9}},
      {"A-pose", {radians(40), 0, 0}},
      {"arms hanging", {radians(12), 0, 0, 0, 0.66, 0, 1}},
  };
  return kStances;
}

TEST(ScanPerson, LiesOnTheTwinAndHasItsMeasures) {
  const BodyParameters twin = person(1, 40, 1.78, 1.02, 0.90, 1.02);
  for (const auto& [name, posture] : stances()) {
    const Body known = body_model().build(twin, posture);
    const auto found = person_from_scan(body_model(), as_scan(known), {"scan.obj", "cm", "y"});
    ASSERT_TRUE(found) << name;
    EXPECT_LT(found->error.p95, kSkin) << name;
    EXPECT_NEAR(degrees(found->posture.arm_abduction), degrees(posture.arm_abduction), 4) << name;
    EXPECT_NEAR(found->posture.elbow_extension, posture.elbow_extension, 0.1) << name;
    for (const char* girth : {"height", "chest", "waist", "hip", "neck", "mid_neck", "upper_arm",
                              "forearm", "wrist", "thigh", "knee", "calf", "ankle", "arm_length",
                              "back_length", "shoulder_breadth", "crotch_height", "scye_depth"})
      EXPECT_NEAR(found->body.measured.at(girth), known.measured.at(girth), kTape)
          << girth << ", " << name;
    for (const auto& [mark, place] : known.landmarks)
      EXPECT_LT((found->body.landmarks.at(mark) - found->body.from_world * in_world(place)).norm(),
                kTape)
          << mark << ", " << name;
  }
}

TEST(ScanPerson, HasTheSameBitsOnOneThreadAsOnMany) {
  const geometry::TriangleMesh scan =
      as_scan(body_model().build(person(0, 30, 1.68, 0.88, 0.72, 0.97), stances()[1].posture));
  const auto fit = [&] { return person_from_scan(body_model(), scan, {"scan.obj", "cm", "y"}); };
  const auto many = fit();
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 1);
  const auto one = fit();
  ASSERT_TRUE(many && one);
  EXPECT_EQ(one->body.surface.vertices, many->body.surface.vertices);
  EXPECT_EQ(one->error.p95, many->error.p95);
}

TEST(ScanPerson, ASmallOldWomanIsNotTakenForAChild) {
  const Body known =
      body_model().build(person(0, 70, 1.46, 0.98, 0.88, 1.00), stances()[1].posture);
  const auto found = person_from_scan(body_model(), as_scan(known), {"scan.obj", "cm", "y"});
  ASSERT_TRUE(found);
  EXPECT_GT(found->parameters.age, 50);
  for (const char* measure : {"chest", "waist", "hip", "armscye", "back_length", "front_balance",
                              "scye_depth", "upper_arm", "neck"})
    EXPECT_NEAR(found->body.measured.at(measure), known.measured.at(measure), kTape) << measure;
}

TEST(ScanPerson, StandsLikeTheTwinWhenPosed) {
  // Scanned with level arms, then with hanging ones: where the twin is when she lowers hers.
  const BodyParameters twin = person(0, 30, 1.66, 0.94, 0.78, 1.00);
  const Posture hanging{radians(25), 0, 0, 0, 0.3};
  const Body level = body_model().build(twin, stances()[0].posture);
  const Body wanted = body_model().build(twin, hanging);
  const auto found = person_from_scan(body_model(), as_scan(level), {"scan.obj", "cm", "y"});
  ASSERT_TRUE(found);
  const Body posed = body_model().build(found->parameters, hanging);
  ASSERT_EQ(posed.surface.vertices.size(), wanted.surface.vertices.size());
  std::vector<double> off;
  const geometry::ClosestPointTree skin(wanted.surface);
  for (std::size_t v = 0; v < posed.surface.vertices.size(); ++v)
    if (posed.segment[v] != Segment::head && posed.segment[v] != Segment::hand &&
        posed.segment[v] != Segment::foot)
      off.push_back(skin.query(posed.surface.vertices[v]).distance);
  std::ranges::sort(off);
  EXPECT_LT(off[off.size() / 2], 0.003);
  EXPECT_LT(off[off.size() * 95 / 100], kTape);
}

TEST(ScanPerson, TellsALeanFromUprightPeople) {
  const BodyParameters twin = person(1, 40, 1.80, 1.10, 1.02, 1.08);
  for (const double bend : {0.0, 30.0}) {
    const Body known = body_model().build(twin, {radians(45), radians(bend)});
    const auto found = person_from_scan(body_model(), as_scan(known), {"scan.obj", "cm", "y"});
    ASSERT_TRUE(found) << bend;
    EXPECT_NEAR(degrees(found->posture.forward_bend), bend, 3);
  }
}

TEST(ScanPerson, ClosesHolesThatATapeCouldNotGuess) {
  const BodyParameters twin = person(0, 30, 1.66, 0.94, 0.78, 1.00);
  const Body known = body_model().build(twin, stances()[1].posture);
  geometry::TriangleMesh scan = as_scan(known);
  // A hole of some 12 cm between the shoulder blades.
  const Vec3 spot = known.landmarks.at("upper_back");
  std::erase_if(scan.triangles, [&](const Triangle& t) {
    return (known.surface.vertices[std::size_t(t[0])] - spot).norm() < 0.06;
  });
  EXPECT_THROW(check_surface(scan, {"scan.obj", "cm", "y"}), GeometryError);
  const auto found = person_from_scan(body_model(), scan, {"scan.obj", "cm", "y"});
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->body.measured.at("chest"), known.measured.at("chest"), kTape);
}

/// Cloth that hangs from the shoulders, farther off the skin the lower it is, in folds.
geometry::TriangleMesh in_a_loose_shirt(const Body& body) {
  Body dressed = body;
  const double hem = body.joints.at("hip_L").z() - 0.05, top = body.joints.at("shoulder_L").z();
  for (std::size_t v = 0; v < body.segment.size(); ++v) {
    const Vec3& p = body.surface.vertices[v];
    if (body.segment[v] != Segment::torso || p.z() < hem) continue;
    const double around = std::atan2(p.x(), -p.y());
    const double drop = std::max(0.0, (top - p.z()) / (top - hem));
    dressed.surface.vertices[v] +=
        (0.005 + drop * (0.07 + 0.03 * std::sin(6 * around))) * body.normals[v];
  }
  return as_scan(dressed);
}

TEST(ScanPerson, LooseClothesAreRefusedWithTheReason) {
  const BodyParameters twin = person(0, 30, 1.66, 0.94, 0.78, 1.00);
  const Body known = body_model().build(twin, stances()[1].posture);
  try {
    const auto found =
        person_from_scan(body_model(), in_a_loose_shirt(known), {"scan.obj", "cm", "y"});
    FAIL() << "taken for skin: " << (found ? found->warnings.back() : "a surface");
  } catch (const InvalidInput& error) {
    EXPECT_NE(std::string(error.what()).find("scan.obj: found clothes or hair"), std::string::npos)
        << error.what();
    EXPECT_NE(std::string(error.what()).find("more than 10 mm outside"), std::string::npos);
    EXPECT_FALSE(error.hint().empty());
  }
}

TEST(ScanPerson, ABellyThatTheModelDoesNotHaveIsSkin) {
  const BodyParameters twin = person(1, 50, 1.76, 1.10, 1.06, 1.08);
  Body known = body_model().build(twin, stances()[1].posture);
  const Vec3 navel = known.landmarks.at("front_waist");
  for (std::size_t v = 0; v < known.segment.size(); ++v) {
    Vec3& p = known.surface.vertices[v];
    if (known.segment[v] == Segment::torso)
      p += 0.04 * std::exp(-(p - navel).squaredNorm() / (2 * 0.12 * 0.12)) * known.normals[v];
  }
  const auto found = person_from_scan(body_model(), as_scan(known), {"scan.obj", "cm", "y"});
  ASSERT_TRUE(found);
  EXPECT_LT(found->error.p95, 0.005);
}

TEST(ScanPerson, IsNobodyWhereThereIsNoPerson) {
  geometry::TriangleMesh ball = support::sphere(0.85, 40, 60);
  for (Vec3& p : ball.vertices) p = Vec3(0.3 * p.x(), 0.2 * p.y(), p.z());
  EXPECT_FALSE(person_from_scan(body_model(), ball, {"ball.obj", "m", "z"}));
}

}  // namespace
}  // namespace loosefit::body

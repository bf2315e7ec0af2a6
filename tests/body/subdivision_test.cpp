#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "loosefit/base/error.h"
#include "loosefit/body/body_fit.h"
#include "loosefit/body/body_tape.h"
#include "loosefit/body/catmull_clark.h"
#include "loosefit/body/rulers.h"
#include "loosefit/body/surface_topology.h"
#include "loosefit/body/tape_paths.h"
#include "support/body_fixture.h"

namespace loosefit::body {
namespace {

const std::vector<std::array<int, 4>> kCube = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4},
                                               {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
const std::vector<Vec3> kCorners = {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1},
                                    {-1, -1, 1},  {1, -1, 1},  {1, 1, 1},  {-1, 1, 1}};

TEST(CatmullClark, CubeAgreesWithHandCalculation) {
  const CatmullClark step(8, kCube);
  EXPECT_EQ(step.fine_vertex_count(), 8 + 12 + 6);
  EXPECT_EQ(step.fine_triangles().size(), 48u);
  const auto fine = step.refine(kCorners);
  // Corner: F = (1/3,1/3,1/3), R = (2/3,2/3,2/3), n = 3: (F + 2R)/3 = 5/9 of the corner.
  EXPECT_LT((fine[6] - Vec3(5, 5, 5) / 9).norm(), 1e-12);
  // Edge point: mean of the two ends and two face points, 3/4 of the edge's middle.
  for (int e = 8; e < 20; ++e)
    EXPECT_NEAR(fine[std::size_t(e)].norm(), 0.75 * std::sqrt(2.), 1e-12);
  for (int f = 20; f < 26; ++f) EXPECT_NEAR(fine[std::size_t(f)].norm(), 1, 1e-12);
  const geometry::TriangleMesh mesh{fine, step.fine_triangles()};
  EXPECT_GT(geometry::enclosed_volume(mesh), 0);
  EXPECT_EQ(inspect_edges(mesh).open, 0);
}

TEST(CatmullClark, AffineMapsCommute) {
  const CatmullClark step(8, kCube);
  Mat3 a;
  a << 1, 0.3, 0, -0.2, 2, 0.1, 0, 0.4, 0.7;
  const Vec3 shift(3, -1, 2);
  auto moved = kCorners;
  for (auto& p : moved) p = a * p + shift;
  const auto first = step.refine(kCorners), second = step.refine(moved);
  for (std::size_t v = 0; v < first.size(); ++v)
    EXPECT_LT((a * first[v] + shift - second[v]).norm(), 1e-12);
}

TEST(CatmullClark, OpenAndNonManifoldMeshesAreRefused) {
  auto open = kCube;
  open.pop_back();
  EXPECT_THROW(CatmullClark(8, open), GeometryError);
  auto doubled = kCube;
  doubled.push_back(kCube[0]);
  EXPECT_THROW(CatmullClark(8, doubled), GeometryError);
}

TEST(Subdivision, BodyCountsAndClosedness) {
  const RestBody rest = body_model().rest({});
  EXPECT_EQ(rest.surface.vertices.size(), 53514u);
  EXPECT_EQ(rest.surface.triangles.size(), 107024u);
  const EdgeReport edges = inspect_edges(rest.surface);
  EXPECT_EQ(edges.open, 0);
  EXPECT_EQ(edges.crowded, 0);
  geometry::TriangleMesh copy = rest.surface;
  EXPECT_EQ(orient_consistently(copy), Orientation::consistent);
}

// The two study children of the reference: what one step takes away, slim / heavy.
TEST(Subdivision, ShrinksTheGirthsOfTheStudyChildrenAsTheReferenceSays) {
  const struct {
    double chest, waist, hip, chest_loss_cm, waist_loss_cm, hip_loss_cm;
  } kChildren[] = {{0.63, 0.55, 0.68, 0.17, 0.22, 0.37}, {0.75, 0.72, 0.80, 0.20, 0.29, 0.47}};
  const BodyModel& model = body_model();
  for (const auto& child : kChildren) {
    BodySpec spec;
    spec.sex = 0.4, spec.age = 10, spec.height = 1.40;
    spec.measurements = {{"chest", child.chest}, {"waist", child.waist}, {"hip", child.hip}};
    const BodyFit fit = fit_body(model, spec, BodyDetail::coarse);
    const RestBody coarse = model.rest(fit.parameters, BodyDetail::coarse);
    const RestBody fine = model.rest(fit.parameters);
    const auto loss_cm = [&](const char* ring) {  // at the level of the unrefined body
      const double z = ruler_centre(coarse.surface.vertices, ring).z();
      return 100 * (trunk_girth(coarse.surface, z) - trunk_girth(fine.surface, z));
    };
    EXPECT_NEAR(loss_cm("bust_circ"), child.chest_loss_cm, 0.012);
    EXPECT_NEAR(loss_cm("waist_circ"), child.waist_loss_cm, 0.012);
    EXPECT_NEAR(loss_cm("hips_circ"), child.hip_loss_cm, 0.012);
    const BodyTape before(model.data(), coarse), after(model.data(), fine);
    EXPECT_NEAR(100 * (before.measure("height") - after.measure("height")), 0.14, 0.01);
    const double share =
        geometry::enclosed_volume(fine.surface) / geometry::enclosed_volume(coarse.surface) - 1;
    EXPECT_NEAR(share, -0.008, 0.0015);
  }
}

TEST(Subdivision, EveryFieldOfABodyIsFilled) {
  const Body body = body_model().build({}, {});
  const std::size_t n = body.surface.vertices.size();
  EXPECT_EQ(body.normals.size(), n);
  EXPECT_EQ(body.segment.size(), n);
  EXPECT_EQ(body.side.size(), n);
  EXPECT_EQ(body.pose_from_rest.size(), n);
  EXPECT_GT(geometry::enclosed_volume(body.surface), 0.04);
  std::map<Segment, int> count;
  for (std::size_t v = 0; v < n; ++v) {
    ++count[body.segment[v]];
    EXPECT_NEAR(body.normals[v].norm(), 1, 1e-9);
    const bool trunk = body.segment[v] == Segment::torso || body.segment[v] == Segment::neck ||
                       body.segment[v] == Segment::head;
    EXPECT_EQ(body.side[v] == 0, trunk);
  }
  EXPECT_EQ(count.size(), 9u);
  for (const char* name :
       {"height",         "chest",       "underbust",    "waist",      "hip",
        "neck",           "upper_arm",   "forearm",      "wrist",      "shoulder_breadth",
        "shoulder_slope", "scye_depth",  "hps_to_waist", "hps_to_hip", "arm_length",
        "chest_level",    "waist_level", "hip_level",    "volume",     "mass"}) {
    ASSERT_TRUE(body.measured.contains(name)) << name;
    EXPECT_GT(body.measured.at(name), 0) << name;
  }
  for (const auto& [name, vertex] : body.landmark_vertex) {
    EXPECT_EQ(body.landmarks.at(name), body.surface.vertices[std::size_t(vertex)]) << name;
  }
  for (const char* name :
       {"c7", "acromion_L", "acromion_R", "scapula_L", "upper_back", "mid_back", "lower_back",
        "front_waist", "back_waist", "crotch", "sternum", "nipple_L", "hps_L"}) {
    EXPECT_TRUE(body.landmarks.contains(name)) << name;
  }
  EXPECT_GT(body.joints.at("shoulder_L").x(), 0);
  EXPECT_LT(body.joints.at("shoulder_R").x(), 0);
}

// What a shirt is drafted from, against tables for a woman of size M and ANSUR II means.
TEST(Subdivision, MeasuresOfAWomanAreThoseOfATailor) {
  BodySpec spec;
  spec.sex = 0, spec.age = 30, spec.height = 1.68;
  spec.measurements = {{"chest", 0.88}, {"waist", 0.72}, {"hip", 0.96}};
  const Body body = body_model().build(fit_body(body_model(), spec).parameters, {});
  EXPECT_NEAR(body.measured.at("neck"), 0.36, 0.02);
  EXPECT_NEAR(body.measured.at("shoulder_breadth"), 0.385, 0.03);
  EXPECT_NEAR(degrees(body.measured.at("shoulder_slope")), 20, 5);
  EXPECT_NEAR(body.measured.at("upper_arm"), 0.284, 0.02);
  EXPECT_NEAR(body.measured.at("scye_depth"), 0.145, 0.02);
  EXPECT_NEAR(body.measured.at("armscye"), 0.38, 0.02);
  EXPECT_NEAR(body.measured.at("hps_to_waist"), 0.425, 0.03);
  const Vec3 to_c7 = body.landmarks.at("c7") - body.landmarks.at("hps_L");
  EXPECT_NEAR(body.measured.at("neck_depth_back"), std::hypot(to_c7.y(), to_c7.z()), 1e-3);
  EXPECT_NEAR(body.measured.at("hps_to_hip"), 0.63, 0.02);
  EXPECT_NEAR(body.measured.at("back_length"), 0.425, 0.025);
  EXPECT_NEAR(body.measured.at("crotch_height"), 0.782, 0.03);
  EXPECT_NEAR(body.measured.at("mass"), 54, 2);
}

}  // namespace
}  // namespace loosefit::body

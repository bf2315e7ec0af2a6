#include "loosefit/render/smooth_skin.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "loosefit/body/body_fit.h"
#include "loosefit/body/named_postures.h"
#include "loosefit/body/section.h"
#include "loosefit/geometry/closest_point_tree.h"
#include "loosefit/render/clear_of_cloth.h"
#include "support/body_fixture.h"

namespace loosefit::render {
namespace {

/// Women of two figures, standing.
class SmoothSkin : public ::testing::TestWithParam<double> {
 protected:
  SmoothSkin()
      : body_(body_model().build(body::fit_body(body_model(), woman()).parameters,
                                 body::named_posture("standing"))),
        form_{smooth_skin(body_), body_.surface.triangles} {}
  static body::BodySpec woman() {
    body::BodySpec spec;
    spec.sex = 0;
    spec.cup = GetParam();
    return spec;
  }
  /// The largest angle between normals of neighbouring vertices less than 3 cm from a place [rad].
  static double roughness(const geometry::TriangleMesh& mesh, const Vec3& near) {
    const std::vector<Vec3> normals = geometry::vertex_normals(mesh.vertices, mesh.triangles);
    double angle = 0;
    for (const Triangle& t : mesh.triangles)
      for (int k = 0; k < 3; ++k) {
        const int a = t[k], b = t[(k + 1) % 3];
        if ((mesh.vertices[a] - near).norm() < 0.03)
          angle = std::max(angle, std::acos(std::clamp(normals[a].dot(normals[b]), -1.0, 1.0)));
      }
    return angle;
  }
  /// The loop round the trunk at a height.
  static body::SectionLoop trunk_at(const geometry::TriangleMesh& mesh, double z) {
    const auto loops = body::plane_section(mesh, {0, 0, z}, Vec3::UnitZ());
    const body::SectionLoop* loop = body::trunk_loop(loops);
    return loop ? *loop : body::SectionLoop{};
  }
  body::Body body_;
  geometry::TriangleMesh form_;
};

TEST_P(SmoothSkin, HasNoNipples) {
  for (const char* name : {"nipple_L", "nipple_R"}) {
    const int v = body_.landmark_vertex.at(name);
    EXPECT_GT(roughness(body_.surface, body_.surface.vertices[v]), 0.5);
    EXPECT_LT(roughness(form_, form_.vertices[v]), 0.2);
  }
}

TEST_P(SmoothSkin, BridgesTheCleftsOfBreastsAndButtocks) {
  const double bust = body_.landmarks.at("nipple_L").z(), hips = body_.joints.at("hip_L").z();
  for (const double z : {bust, hips, 0.5 * (bust + hips)}) {
    const body::SectionLoop loop = trunk_at(form_, z);
    ASSERT_GT(loop.length, 0.5);
    EXPECT_LT(loop.length / body::hull_perimeter(loop.points, Vec3::UnitZ()), 1.004) << z;
  }
  const body::SectionLoop skin = trunk_at(body_.surface, hips);
  EXPECT_GT(skin.length / body::hull_perimeter(skin.points, Vec3::UnitZ()), 1.004);
}

TEST_P(SmoothSkin, KeepsTheGirths) {
  const double waist = body_.landmarks.at("front_waist").z(), hips = body_.joints.at("hip_L").z();
  for (const double z : {waist, hips, hips + 0.05})
    EXPECT_NEAR(body::hull_perimeter(trunk_at(form_, z).points, Vec3::UnitZ()),
                body::hull_perimeter(trunk_at(body_.surface, z).points, Vec3::UnitZ()), 0.012)
        << z;
  // A few millimetres off in the middle, on trunk, legs and arms.
  const geometry::ClosestPointTree skin(body_.surface);
  std::vector<double> off;
  for (std::size_t v = 0; v < form_.vertices.size(); ++v)
    if (body_.segment[v] != body::Segment::head && body_.segment[v] != body::Segment::hand)
      off.push_back(skin.query(form_.vertices[v]).distance);
  std::ranges::nth_element(off, off.begin() + static_cast<std::ptrdiff_t>(off.size() / 2));
  EXPECT_LT(off[off.size() / 2], 0.003);
}

TEST_P(SmoothSkin, StaysWithinCloseCloth) {
  // Cloth 4 mm from the skin. In creases, where skin faces skin, it crosses itself: those, toes and
  // fingers are left out.
  geometry::TriangleMesh cloth = body_.surface;
  for (std::size_t v = 0; v < cloth.vertices.size(); ++v)
    cloth.vertices[v] += 0.004 * body_.normals[v];
  const geometry::ClosestPointTree skin(body_.surface), outside(cloth);
  const std::vector<Vec3> places = clear_of_cloth(
      skin, form_.vertices, geometry::vertex_normals(form_.vertices, form_.triangles), cloth);
  int looked_at = 0, poking = 0, smooth_poking = 0;
  for (std::size_t v = 0; v < places.size(); ++v) {
    const body::Segment segment = body_.segment[v];
    const Vec3 before = body_.surface.vertices[v] + 0.020 * body_.normals[v];
    if (segment == body::Segment::head || segment == body::Segment::hand ||
        segment == body::Segment::foot || skin.query(before).distance < 0.018 ||
        outside.signed_distance(body_.surface.vertices[v]) > 0)
      continue;
    ++looked_at;
    const auto is_out = [&](const Vec3& p) {
      return skin.signed_distance(p) > 0 && outside.signed_distance(p) > 0;
    };
    poking += is_out(places[v]);
    smooth_poking += is_out(form_.vertices[v]);
  }
  EXPECT_EQ(poking, 0);
  EXPECT_GT(smooth_poking, 100);
  EXPECT_GT(looked_at, 10000);
}

INSTANTIATE_TEST_SUITE_P(Figures, SmoothSkin, ::testing::Values(0.5, 1.0));

}  // namespace
}  // namespace loosefit::render

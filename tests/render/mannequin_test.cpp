#include "loosefit/render/mannequin.h"

#include <gtest/gtest.h>

#include "support/tube_garment.h"

namespace loosefit {
namespace {

/// An upright cylinder with the joints of a person and a tube from z = 0.8 to 1.3.
class Mannequin : public ::testing::Test {
 protected:
  void SetUp() override {
    body_.joints = {{"neck", {0, 0, 1.4}},      {"head", {0, 0, 1.52}},
                    {"hip_L", {0.06, 0, 0.9}},  {"hip_R", {-0.06, 0, 0.9}},
                    {"knee_L", {0.06, 0, 0.5}}, {"knee_R", {-0.06, 0, 0.5}}};
    garment_ = testing::tube_garment(0.8, 0.5, 60, 30);
    positions_ = testing::settled_drape(garment_, [](const Vec2& uv) {
                   const double a = 2 * kPi * uv.x() / 0.8;
                   return Vec3(0.13 * std::cos(a), 0.13 * std::sin(a), 0.8 + uv.y());
                 }).positions;
  }
  static std::pair<double, double> extent(const TriangleMesh& mesh) {
    double low = 1e9, high = -1e9;
    for (const Triangle& t : mesh.triangles)
      for (int v : t) {
        low = std::min(low, mesh.vertices[v].z());
        high = std::max(high, mesh.vertices[v].z());
      }
    return {low, high};
  }
  Body body_ = testing::cylinder_body(0.12, 1.7, 60, 40);
  Garment garment_;
  std::vector<Vec3> positions_;
};

TEST_F(Mannequin, EndsInsideTheHemAndAtTheNeck) {
  const TriangleMesh form = mannequin(body_, garment_, positions_);
  const auto [low, high] = extent(form);
  EXPECT_NEAR(low, 0.83, 1e-9);
  EXPECT_NEAR(high, 1.4 + 0.4 * 0.12, 1e-9);
}

TEST_F(Mannequin, TheNeckIsClosedByALid) {
  const TriangleMesh form = mannequin(body_, garment_, positions_);
  double lid = 0;
  for (const Triangle& t : form.triangles) {
    const Vec3 n = triangle_normal(form.vertices[t[0]], form.vertices[t[1]], form.vertices[t[2]]);
    if (n.z() > 0.999)
      lid += triangle_area(form.vertices[t[0]], form.vertices[t[1]], form.vertices[t[2]]);
  }
  EXPECT_NEAR(lid, kPi * 0.12 * 0.12, 0.003 * kPi * 0.12 * 0.12);
}

TEST_F(Mannequin, LegsAreNeverShown) {
  for (std::size_t v = 0; v < body_.surface.vertices.size(); ++v)
    if (body_.surface.vertices[v].z() < 0.85) body_.segment[v] = Segment::thigh;
  EXPECT_GT(extent(mannequin(body_, garment_, positions_)).first, 0.8);
  // Sitting: the knees in front, thighs cut to stubs.
  body_.joints["knee_L"] = {0.06, -0.4, 0.9};
  body_.joints["knee_R"] = {-0.06, -0.4, 0.9};
  for (const Vec3& p : mannequin(body_, garment_, positions_).vertices) EXPECT_GT(p.y(), -0.13);
}

TEST_F(Mannequin, AScanWithoutJointsKeepsItsHead) {
  body_.joints.clear();
  const auto [low, high] = extent(mannequin(body_, garment_, positions_));
  EXPECT_NEAR(low, 0.83, 1e-9);
  EXPECT_NEAR(high, 1.7, 1e-9);
}

TEST(Clipped, SplitsTrianglesAtTheCut) {
  const TriangleMesh one{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  std::vector<std::array<int, 2>> rim;
  const TriangleMesh part = clipped(one, {0.25, -0.75, 0.25}, &rim);
  double area = 0;
  for (const Triangle& t : part.triangles)
    area += triangle_area(part.vertices[t[0]], part.vertices[t[1]], part.vertices[t[2]]);
  EXPECT_NEAR(area, 0.5 - 0.5 * 0.75 * 0.75, 1e-12);
  EXPECT_EQ(rim.size(), 1u);
  EXPECT_TRUE(clipped(one, {-1, -1, -1}).triangles.empty());
  EXPECT_EQ(clipped(one, {1, 1, 1}).triangles.size(), 1u);
}

}  // namespace
}  // namespace loosefit

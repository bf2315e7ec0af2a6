#include "loosefit/render/mannequin.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "loosefit/body/body_fit.h"
#include "loosefit/body/mesh_repair.h"
#include "loosefit/body/named_postures.h"
#include "loosefit/body/surface_topology.h"
#include "loosefit/geometry/convex_hull.h"
#include "support/body_fixture.h"
#include "support/tube_garment.h"

namespace loosefit::render {
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
  static std::pair<double, double> extent(const geometry::TriangleMesh& mesh) {
    double low = 1e9, high = -1e9;
    for (const Triangle& t : mesh.triangles)
      for (int v : t) {
        low = std::min(low, mesh.vertices[v].z());
        high = std::max(high, mesh.vertices[v].z());
      }
    return {low, high};
  }
  body::Body body_ = testing::cylinder_body(0.12, 1.7, 60, 40);
  garment::Garment garment_;
  std::vector<Vec3> positions_;
};

TEST_F(Mannequin, EndsInsideTheHemAndAtTheNeck) {
  const geometry::TriangleMesh form = mannequin(body_, garment_, positions_);
  const auto [low, high] = extent(form);
  EXPECT_NEAR(low, 0.83, 1e-9);
  EXPECT_NEAR(high, 1.4 + 0.4 * 0.12, 1e-9);
}

TEST_F(Mannequin, TheNeckIsClosedByALid) {
  const geometry::TriangleMesh form = mannequin(body_, garment_, positions_);
  double lid = 0;
  for (const Triangle& t : form.triangles) {
    const Vec3 n =
        geometry::triangle_normal(form.vertices[t[0]], form.vertices[t[1]], form.vertices[t[2]]);
    if (n.z() > 0.999)
      lid += geometry::triangle_area(form.vertices[t[0]], form.vertices[t[1]], form.vertices[t[2]]);
  }
  EXPECT_NEAR(lid, kPi * 0.12 * 0.12, 0.003 * kPi * 0.12 * 0.12);
}

TEST_F(Mannequin, LegsAreNeverShown) {
  for (std::size_t v = 0; v < body_.surface.vertices.size(); ++v)
    if (body_.surface.vertices[v].z() < 0.85) body_.segment[v] = body::Segment::thigh;
  EXPECT_GT(extent(mannequin(body_, garment_, positions_)).first, 0.8);
  // Sitting: the knees in front, thighs cut to stubs.
  body_.joints["knee_L"] = {0.06, -0.4, 0.9};
  body_.joints["knee_R"] = {-0.06, -0.4, 0.9};
  for (const Vec3& p : mannequin(body_, garment_, positions_).vertices) EXPECT_GT(p.y(), -0.13);
}

TEST(MannequinOfAPerson, StandsOnLastsInWhatHangsToTheShanks) {
  const body::BodyFit fit = body::fit_body(body_model(), {});
  const garment::Garment tube = testing::tube_garment(0.8, 0.6, 60, 30);
  for (const char* posture : {"standing", "stride", "sitting"}) {
    SCOPED_TRACE(posture);
    const body::Body body = body_model().build(fit.parameters, body::named_posture(posture));
    // Round the right leg, from the middle of the thigh to that of the shank.
    const Vec3 hip = body.joints.at("hip_R"), knee = body.joints.at("knee_R"),
               ankle = body.joints.at("ankle_R");
    const Vec3 top = 0.5 * (hip + knee), bottom = 0.5 * (knee + ankle);
    const auto round = [&](double lowest) {
      return testing::settled_drape(tube,
                                    [&](const Vec2& uv) {
                                      const double a = 2 * kPi * uv.x() / 0.8,
                                                   share = 1 - uv.y() / 0.6;
                                      return Vec3(top + share * lowest * (bottom - top) +
                                                  0.12 * Vec3(std::cos(a), std::sin(a), 0));
                                    })
          .positions;
    };
    const geometry::TriangleMesh form = mannequin(body, tube, round(1));
    double floor = 1, skin = 1;
    for (const Vec3& p : form.vertices) floor = std::min(floor, p.z());
    for (const Vec3& p : body.surface.vertices) skin = std::min(skin, p.z());
    EXPECT_NEAR(floor, skin, 1e-9);
    // No toe sticks out of the lasts.
    std::vector<Vec3> foot;
    for (std::size_t v = 0; v < body.segment.size(); ++v)
      if (body.segment[v] == body::Segment::foot && body.side[v] < 0)
        foot.push_back(body.surface.vertices[v]);
    const geometry::TriangleMesh last = geometry::convex_hull(foot);
    int found = 0;
    for (const Vec3& p : last.vertices)
      found += std::ranges::find(form.vertices, p) != form.vertices.end();
    EXPECT_EQ(found, static_cast<int>(last.vertices.size()));
    // What ends on the thigh shows no leg.
    double lowest = 1;
    for (const Vec3& p : mannequin(body, tube, round(0.2)).vertices)
      lowest = std::min(lowest, p.z());
    EXPECT_GT(lowest, skin + 0.2);
  }
}

TEST_F(Mannequin, AScanWithoutJointsKeepsItsHead) {
  body_.joints.clear();
  const auto [low, high] = extent(mannequin(body_, garment_, positions_));
  EXPECT_NEAR(low, 0.83, 1e-9);
  EXPECT_NEAR(high, 1.7, 1e-9);
}

TEST_F(Mannequin, RaisedArmsBesideTheNeckStay) {
  // Two posts beside the neck that reach above it, one of them named.
  const auto post = [&](double x, body::Segment segment) {
    const int first = static_cast<int>(body_.surface.vertices.size());
    for (const double z : {1.2, 1.6})
      for (const auto& [dx, dy] : {std::pair{0.02, 0.0}, {-0.02, 0.01}, {-0.02, -0.01}}) {
        body_.surface.vertices.push_back({x + dx, dy, z});
        body_.segment.push_back(segment);
        body_.side.push_back(0);
      }
    for (int k = 0; k < 3; ++k) {
      const int a = first + k, b = first + (k + 1) % 3;
      body_.surface.triangles.push_back({a, b, b + 3});
      body_.surface.triangles.push_back({a, b + 3, a + 3});
    }
  };
  post(0.18, body::Segment::upper_arm);
  EXPECT_NEAR(extent(mannequin(body_, garment_, positions_)).second, 1.6, 1e-9);
  post(-0.18, body::Segment::head);
  for (const Vec3& p : mannequin(body_, garment_, positions_).vertices)
    EXPECT_LT(p.z(), p.x() > 0.15 ? 1.61 : 1.45);
}

TEST_F(Mannequin, TheStubOfALiftedThighIsClosedByALid) {
  body_.joints["knee_L"] = {0.06, -0.4, 0.9};
  body_.joints["knee_R"] = {-0.06, -0.4, 0.9};
  // A beam forward from the right hip.
  const int first = static_cast<int>(body_.surface.vertices.size());
  for (int k = 0; k < 8; ++k)
    for (const double y : {0.0, -0.4}) {
      body_.surface.vertices.push_back(
          {-0.06 + 0.05 * std::cos(kPi / 4 * k), y, 0.9 + 0.05 * std::sin(kPi / 4 * k)});
      body_.segment.push_back(body::Segment::thigh);
      body_.side.push_back(-1);
    }
  for (int k = 0; k < 8; ++k) {
    const int a = first + 2 * k, b = first + 2 * ((k + 1) % 8);
    body_.surface.triangles.push_back({a, b, b + 1});
    body_.surface.triangles.push_back({a, b + 1, a + 1});
  }
  const geometry::TriangleMesh form = mannequin(body_, garment_, positions_);
  double lid = 0;
  for (const Triangle& t : form.triangles) {
    const Vec3 a = form.vertices[t[0]], b = form.vertices[t[1]], c = form.vertices[t[2]];
    if (geometry::triangle_normal(a, b, c).y() > -0.999) continue;
    lid += geometry::triangle_area(a, b, c);
    EXPECT_NEAR(a.y(), -0.10, 1e-9);
  }
  EXPECT_NEAR(lid, 4 * std::sin(kPi / 4) * 0.05 * 0.05, 1e-9);
}

/// A tube round the trunk from 5 cm below the hips upwards.
std::vector<Vec3> tube_round(const garment::Garment& tube, const Vec3& hips, const Vec3& axis) {
  const Vec3 across = axis.cross(Vec3::UnitX()).normalized(), right = across.cross(axis);
  return testing::settled_drape(tube,
                                [&](const Vec2& uv) {
                                  const double a = 2 * kPi * uv.x() / 0.8;
                                  return Vec3(hips + (uv.y() - 0.05) * axis +
                                              0.25 * (std::cos(a) * right + std::sin(a) * across));
                                })
      .positions;
}

TEST(MannequinOfAPerson, IsOpenAtTheHemAloneAndKeepsItsHandsButNoJaw) {
  const body::BodyFit fit = body::fit_body(body_model(), {});
  const garment::Garment tube = testing::tube_garment(0.8, 0.5, 60, 30);
  for (const char* posture :
       {"standing", "forward-bend-45", "slouch", "arms-overhead", "sitting"}) {
    const body::Body body = body_model().build(fit.parameters, body::named_posture(posture));
    const Vec3 hips = 0.5 * (body.joints.at("hip_L") + body.joints.at("hip_R"));
    const Vec3 axis = (body.joints.at("neck") - hips).normalized();
    const std::vector<Vec3> positions = tube_round(tube, hips, axis);
    geometry::TriangleMesh form = mannequin(body, tube, positions);
    body::weld_seams(form, 1e-9);
    std::map<std::pair<int, int>, int> faces;
    for (const Triangle& t : form.triangles)
      for (int k = 0; k < 3; ++k) ++faces[std::minmax(t[k], t[(k + 1) % 3])];
    const bool sits = std::string(posture) == "sitting";
    const double hem = (hips - 0.05 * axis).dot(axis) + (sits ? 0 : 0.03);
    int open = 0;
    for (const auto& [edge, count] : faces) {
      if (count != 1) continue;
      ++open;
      EXPECT_NEAR(form.vertices[edge.first].dot(axis), hem, 1e-6) << posture;
    }
    EXPECT_GT(open, 20) << posture;
    std::size_t hands = 0;
    for (std::size_t v = 0; v < body.segment.size(); ++v)
      hands += body.segment[v] == body::Segment::hand;
    EXPECT_GT(form.vertices.size(), hands) << posture;
    std::set<std::array<double, 3>> head;
    for (std::size_t v = 0; v < body.segment.size(); ++v)
      if (const Vec3& p = body.surface.vertices[v]; body.segment[v] == body::Segment::head)
        head.insert({p.x(), p.y(), p.z()});
    int left = 0;
    for (const Vec3& p : mannequin(body, tube, positions).vertices)
      left += static_cast<int>(head.count({p.x(), p.y(), p.z()}));
    EXPECT_LT(left, 0.001 * static_cast<double>(head.size())) << posture;
  }
}

}  // namespace
}  // namespace loosefit::render

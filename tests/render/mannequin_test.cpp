#include "loosefit/render/mannequin.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "loosefit/body/body_fit.h"
#include "loosefit/body/mesh_repair.h"
#include "loosefit/body/named_postures.h"
#include "loosefit/body/surface_topology.h"
#include "loosefit/geometry/closest_point_tree.h"
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
  EXPECT_NEAR(lid, kPi * 0.12 * 0.12, 0.01 * kPi * 0.12 * 0.12);
}

TEST_F(Mannequin, NoLegsAreShownInWhatEndsAtTheCrotch) {
  for (std::size_t v = 0; v < body_.surface.vertices.size(); ++v)
    if (body_.surface.vertices[v].z() < 0.85) body_.segment[v] = body::Segment::thigh;
  EXPECT_GT(extent(mannequin(body_, garment_, positions_)).first, 0.8);
  // Sitting: the knees in front, thighs cut to stubs.
  body_.joints["knee_L"] = {0.06, -0.4, 0.9};
  body_.joints["knee_R"] = {-0.06, -0.4, 0.9};
  for (const Vec3& p : mannequin(body_, garment_, positions_).vertices) EXPECT_GT(p.y(), -0.14);
}

TEST_F(Mannequin, ShowsTheTrunkDownToTheHipsUnderAShortTop) {
  for (Vec3& p : positions_) p.z() = 1.1 + (p.z() - 0.8) * 0.5;
  EXPECT_NEAR(extent(mannequin(body_, garment_, positions_)).first, 0.9, 1e-9);
}

/// A person and the places of vertices of a tube round it.
class MannequinOfAPerson : public ::testing::Test {
 protected:
  static body::BodySpec woman() {
    body::BodySpec spec;
    spec.sex = 0;
    return spec;
  }
  static body::Body in(const char* posture) {
    static const body::BodyFit fit = body::fit_body(body_model(), woman());
    return body_model().build(fit.parameters, body::named_posture(posture));
  }
  /// Of the given radius along a line.
  std::vector<Vec3> tube_along(const Vec3& top, const Vec3& bottom, double radius) const {
    const Vec3 axis = (top - bottom).normalized();
    const Vec3 across = axis.cross(Vec3::UnitX()).normalized(), right = across.cross(axis);
    return testing::settled_drape(
               tube_,
               [&](const Vec2& uv) {
                 const double a = 2 * kPi * uv.x() / 0.8;
                 return Vec3(bottom + uv.y() / 0.5 * (top - bottom) +
                             radius * (std::cos(a) * right + std::sin(a) * across));
               })
        .positions;
  }
  static Vec3 hips(const body::Body& body) {
    return 0.5 * (body.joints.at("hip_L") + body.joints.at("hip_R"));
  }
  static double lowest(const std::vector<Vec3>& points) {
    double low = 1e9;
    for (const Vec3& p : points) low = std::min(low, p.z());
    return low;
  }
  static double highest(const std::vector<Vec3>& points) {
    double high = -1e9;
    for (const Vec3& p : points) high = std::max(high, p.z());
    return high;
  }
  garment::Garment tube_ = testing::tube_garment(0.8, 0.5, 60, 30);
};

TEST_F(MannequinOfAPerson, StandsOnLastsInWhatGoesBelowTheCrotch) {
  for (const char* posture : {"standing", "stride", "sitting"}) {
    SCOPED_TRACE(posture);
    const body::Body body = in(posture);
    const Vec3 hip = body.joints.at("hip_R"), knee = body.joints.at("knee_R");
    const double floor = lowest(body.surface.vertices);
    // Shorts: a leg of them, down to the middle of the thigh; long trousers: to the ankle.
    for (const Vec3& hem : {Vec3(0.5 * (hip + knee)), body.joints.at("ankle_R")}) {
      const geometry::TriangleMesh form = mannequin(body, tube_, tube_along(hip, hem, 0.12));
      EXPECT_NEAR(lowest(form.vertices), floor, 0.004);
      // No toe sticks out of the lasts: nothing lies beside the hull of the foot.
      std::vector<Vec3> foot;
      for (std::size_t v = 0; v < body.segment.size(); ++v)
        if (body.segment[v] == body::Segment::foot && body.side[v] < 0)
          foot.push_back(body.surface.vertices[v]);
      const geometry::TriangleMesh hull = geometry::convex_hull(foot);
      const geometry::ClosestPointTree last(hull);
      const double ankle = body.joints.at("ankle_R").z() - 0.03;
      for (const Vec3& p : form.vertices)
        if (p.x() < 0 && p.z() < ankle && std::abs(p.y() - body.joints.at("ankle_R").y()) < 0.3) {
          EXPECT_LT(last.signed_distance(p), 0.004);
        }
    }
    // What ends at the crotch shows no leg.
    const Vec3 end = hip - Vec3(0, 0, 0.03);
    const auto short_one =
        mannequin(body, tube_, tube_along(hip + Vec3(0, 0, 0.3), end, 0.12)).vertices;
    EXPECT_GT(lowest(short_one), floor + 0.2);
  }
}

TEST_F(MannequinOfAPerson, InASkirtHasATrunkWithoutArms) {
  const body::Body body = in("standing");
  const Vec3 middle = hips(body);
  const auto form =
      mannequin(body, tube_, tube_along(middle + Vec3(0, 0, 0.1), middle - Vec3(0, 0, 0.4), 0.25));
  EXPECT_GT(highest(form.vertices), body.joints.at("neck").z());
  EXPECT_LT(highest(form.vertices), body.joints.at("head").z());
  const Vec3 elbow = body.joints.at("elbow_L");
  for (const Vec3& p : form.vertices)
    if (std::abs(p.z() - elbow.z()) < 0.05) {
      EXPECT_LT(std::abs(p.x()), elbow.x() - 0.03);
    }
}

TEST_F(MannequinOfAPerson, HasAnEggWithoutAFaceInAHoodAlone) {
  const body::Body body = in("standing");
  const Vec3 neck = body.joints.at("neck"), head = body.joints.at("head");
  const auto in_hood =
      mannequin(body, tube_, tube_along(head + Vec3(0, 0, 0.15), neck - Vec3(0, 0, 0.3), 0.20));
  const auto in_shirt = mannequin(body, tube_, tube_along(neck, hips(body), 0.25));
  EXPECT_LT(highest(in_shirt.vertices), head.z());
  EXPECT_NEAR(highest(in_hood.vertices), highest(body.surface.vertices), 0.01);
  // Round everywhere: normals of neighbouring places are alike, as they are not at ears and nose.
  const auto roughest = [&](const geometry::TriangleMesh& mesh) {
    const std::vector<Vec3> normals = geometry::vertex_normals(mesh.vertices, mesh.triangles);
    double angle = 0;
    for (const Triangle& t : mesh.triangles)
      for (int k = 0; k < 3; ++k) {
        const int a = t[k], b = t[(k + 1) % 3];
        if (mesh.vertices[a].z() > head.z() + 0.04)
          angle = std::max(angle, std::acos(std::clamp(normals[a].dot(normals[b]), -1.0, 1.0)));
      }
    return angle;
  };
  EXPECT_LT(roughest(in_hood), 0.3);
  EXPECT_GT(roughest(body.surface), 0.6);
}

TEST_F(MannequinOfAPerson, HasNoFingers) {
  const body::Body body = in("standing");
  const auto form = mannequin(body, tube_, tube_along(body.joints.at("neck"), hips(body), 0.25));
  const Vec3 wrist = body.joints.at("wrist_L"), knuckle = body.joints.at("hand_L");
  const Vec3 along = (knuckle - wrist).normalized();
  double reach = 0, width = 0;
  for (const Vec3& p : form.vertices) {
    const double beyond = (p - wrist).dot(along);
    if ((p - wrist).norm() > 0.25 || beyond < 0.02 || p.x() < 0.15) continue;
    reach = std::max(reach, beyond);
    width = std::max(width, (p - wrist - beyond * along).norm());
  }
  EXPECT_GT(reach, 0.06);
  EXPECT_LT(reach, 0.10);
  EXPECT_LT(width, 0.04);
}

TEST_F(Mannequin, AScanWithoutJointsKeepsItsHead) {
  body_.joints.clear();
  const auto [low, high] = extent(mannequin(body_, garment_, positions_));
  EXPECT_NEAR(low, 0.83, 1e-9);
  EXPECT_NEAR(high, 1.7, 0.003);
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
  EXPECT_NEAR(extent(mannequin(body_, garment_, positions_)).second, 1.6, 0.001);
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
  EXPECT_NEAR(lid, 4 * std::sin(kPi / 4) * 0.05 * 0.05, 0.001);
}

TEST_F(MannequinOfAPerson, IsClosedAndHasNoJaw) {
  for (const char* posture :
       {"standing", "forward-bend-45", "slouch", "arms-overhead", "sitting"}) {
    SCOPED_TRACE(posture);
    const body::Body body = in(posture);
    const Vec3 low = hips(body), axis = (body.joints.at("neck") - low).normalized();
    const Vec3 knee = 0.5 * (body.joints.at("knee_L") + body.joints.at("knee_R"));
    for (const auto& positions : {tube_along(low + 0.45 * axis, low - 0.05 * axis, 0.25),
                                  tube_along(low + 0.1 * axis, knee, 0.25)}) {
      geometry::TriangleMesh form = mannequin(body, tube_, positions);
      int left = 0, all = 0;
      std::set<std::array<double, 3>> head;
      for (std::size_t v = 0; v < body.segment.size(); ++v)
        if (const Vec3& p = body.surface.vertices[v]; body.segment[v] == body::Segment::head)
          head.insert({p.x(), p.y(), p.z()}), ++all;
      for (const Vec3& p : form.vertices)
        left += static_cast<int>(head.count({p.x(), p.y(), p.z()}));
      EXPECT_LT(left, 0.001 * all);
      body::weld_seams(form, 1e-9);
      std::map<std::pair<int, int>, int> faces;
      for (const Triangle& t : form.triangles)
        for (int k = 0; k < 3; ++k) ++faces[std::minmax(t[k], t[(k + 1) % 3])];
      int open = 0;
      for (const auto& [edge, count] : faces) open += count % 2;
      EXPECT_EQ(open, 0);
    }
  }
}

}  // namespace
}  // namespace loosefit::render

#include "loosefit/body/skin_overlap.h"

#include <algorithm>

#include "loosefit/geometry/closest_point.h"
#include "loosefit/geometry/exact_intersection.h"

namespace loosefit {
namespace {

constexpr double kReach = 0.03;    ///< deepest overlap that is parted [m]
constexpr double kShallow = 0.01;  ///< overlap by which others are found [m]
constexpr double kEnough = 0.7;    ///< share of the gap at which it is well
constexpr double kOpposed = -0.3;  ///< cosine between the normals of skins that face each other
constexpr double kBrought = 0.5;   ///< they have come together to less than that share of before
constexpr double kTouch = 0.001;   ///< overlap that counts [m]
constexpr double kNearShoulder = 0.18;  ///< trunk that may meet the upper arm [m]
constexpr int kRounds = 10, kSmoothings = 2;

bool is_arm(Segment s) { return s == Segment::upper_arm || s == Segment::forearm; }

/// Skin that faces a vertex, brought near by the posture.
class FacingSkin {
 public:
  FacingSkin(const Body& body, const std::vector<Vec3>& rest)
      : body_(body), rest_(rest), tree_(body.surface) {}

  /// Distance of vertex v outside the skin that faces it [m], negative inside, with that skin's
  /// normal; `reach` when there is none within that.
  double distance(int v, double reach, Vec3& normal) const {
    const Vec3& p = body_.surface.vertices[v];
    const auto faces = [&](int t) {
      const int a = body_.surface.triangles[t][0];
      if (body_.normals[v].dot(body_.normals[a]) > kOpposed) return false;
      return (p - body_.surface.vertices[a]).norm() < kBrought * (rest_[v] - rest_[a]).norm();
    };
    const ClosestPoint hit = tree_.query(p, reach, faces);
    if (hit.triangle < 0) return reach;
    const auto& [a, b, c] = body_.surface.triangles[hit.triangle];
    const auto& x = body_.surface.vertices;
    normal = triangle_normal(x[a], x[b], x[c]);
    return (p - hit.point).dot(normal);
  }

 private:
  const Body& body_;
  const std::vector<Vec3>& rest_;
  ClosestPointTree tree_;
};

/// Arms, and what of the trunk is near enough to a shoulder to meet the upper arm.
std::vector<int> watched_vertices(const Body& body) {
  std::vector<int> found;
  for (int v = 0; v < static_cast<int>(body.surface.vertices.size()); ++v) {
    bool watched = is_arm(body.segment[v]);
    if (body.segment[v] == Segment::torso)
      for (const char* joint : {"shoulder_L", "shoulder_R"})
        watched |= (body.surface.vertices[v] - body.joints.at(joint)).norm() < kNearShoulder;
    if (watched) found.push_back(v);
  }
  return found;
}

/// Skin of the arms and the trunk within kReach of the vertices `centres`, side by side.
std::vector<int> vertices_round(const Body& body, const std::vector<int>& centres) {
  const auto& x = body.surface.vertices;
  Eigen::AlignedBox3d box[2];  // of the two sides of the body
  for (int v : centres) box[x[v][0] > 0].extend(x[v]);
  std::vector<int> found;
  for (int v = 0; v < static_cast<int>(x.size()); ++v) {
    const Segment s = body.segment[v];
    const Eigen::AlignedBox3d& mine = box[x[v][0] > 0];
    if ((is_arm(s) || s == Segment::torso || s == Segment::thigh) && !mine.isEmpty() &&
        mine.exteriorDistance(x[v]) < kReach)
      found.push_back(v);
  }
  return found;
}

/// Triangle pairs of arm and trunk that cut each other.
std::size_t crossings(const Body& body) {
  TriangleMesh skin;
  skin.vertices = body.surface.vertices;
  for (const Triangle& t : body.surface.triangles)
    if (is_arm(body.segment[t[0]]) || body.segment[t[0]] == Segment::torso)
      skin.triangles.push_back(t);
  return self_intersections(skin.vertices, skin.triangles).size();
}

void smooth(const std::vector<Triangle>& triangles, std::vector<Vec3>& u) {
  std::vector<Vec3> sum = u;
  std::vector<int> count(u.size(), 1);
  for (const Triangle& t : triangles)
    for (int k = 0; k < 3; ++k) {
      sum[t[k]] += u[t[(k + 1) % 3]] + u[t[(k + 2) % 3]];
      count[t[k]] += 2;
    }
  for (std::size_t i = 0; i < u.size(); ++i) u[i] = sum[i] / count[i];
}

}  // namespace

double part_overlapping_skin(Body& body, const std::vector<Vec3>& rest) {
  std::vector<int> watched;
  {
    // Every overlap is shallow somewhere.
    const FacingSkin facing(body, rest);
    for (int v : watched_vertices(body)) {
      Vec3 normal = Vec3::Zero();
      if (facing.distance(v, kShallow, normal) < -kTouch) watched.push_back(v);
    }
  }
  if (watched.empty()) return 0;
  watched = vertices_round(body, watched);
  const Body before = body;
  const std::size_t crossings_before = crossings(body);
  for (int round = 0; round < kRounds; ++round) {
    const FacingSkin facing(body, rest);
    std::vector<Vec3> u(rest.size(), Vec3::Zero());
    double least = kSkinGap;
    for (int v : watched) {
      Vec3 normal = Vec3::Zero();
      const double d = facing.distance(v, kReach, normal);
      least = std::min(least, d);
      if (d < kSkinGap) u[v] = 0.5 * (kSkinGap - d) * normal;
    }
    if (least > kEnough * kSkinGap) break;
    for (int k = 0; k < kSmoothings; ++k) smooth(body.surface.triangles, u);
    for (std::size_t i = 0; i < u.size(); ++i) body.surface.vertices[i] += u[i];
    body.normals = vertex_normals(body.surface.vertices, body.surface.triangles);
  }
  if (crossings(body) > crossings_before / 4) {  // skin that was crumpled, not pushed together
    body = before;
    return 0;
  }
  double most = 0;
  for (std::size_t i = 0; i < rest.size(); ++i) {
    const Vec3 moved = body.surface.vertices[i] - before.surface.vertices[i];
    most = std::max(most, moved.norm());
    if (!body.pose_from_rest.empty()) body.pose_from_rest[i].col(3) += moved;
  }
  return most;
}

}  // namespace loosefit

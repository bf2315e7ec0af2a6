#include "loosefit/body/body_frame.h"

#include <cmath>
#include <optional>
#include <string>

#include "loosefit/base/error.h"
#include "loosefit/geometry/least_squares.h"

namespace loosefit::body {
namespace {

std::optional<Vec3> joint(const Body& body, const std::string& name) {
  const auto found = body.joints.find(name);
  return found == body.joints.end() ? std::nullopt : std::optional<Vec3>(found->second);
}

/// Unit vector between two joints, zero when one is missing.
Vec3 between(const Body& body, const std::string& from, const std::string& to) {
  const auto a = joint(body, from), b = joint(body, to);
  return a && b ? Vec3((*b - *a).stableNormalized()) : Vec3(Vec3::Zero());
}

Vec3 limb_axis(const Body& body, Segment segment, int side) {
  const std::string under = side >= 0 ? "_L" : "_R";
  switch (segment) {
    case Segment::upper_arm:
      return between(body, "elbow" + under, "shoulder" + under);
    case Segment::forearm:
      return between(body, "wrist" + under, "elbow" + under);
    case Segment::hand:
      return between(body, "hand" + under, "wrist" + under);
    case Segment::thigh:
      return between(body, "knee" + under, "hip" + under);
    case Segment::shank:
      return between(body, "ankle" + under, "knee" + under);
    case Segment::head:
    case Segment::neck:
      return between(body, "neck", "head");
    default:
      return Vec3::Zero();
  }
}

}  // namespace

std::vector<Vec3> segment_axes(const Body& body) {
  constexpr int kSegments = static_cast<int>(Segment::foot) + 1;
  Vec3 limb[kSegments][2];
  for (int s = 0; s < kSegments; ++s)
    for (const int left : {0, 1})
      limb[s][left] = limb_axis(body, static_cast<Segment>(s), left ? 1 : -1);
  const bool posed = body.pose_from_rest.size() == body.surface.vertices.size();
  const Vec3 trunk = between(body, "pelvis", "neck");
  std::vector<Vec3> axes(body.surface.vertices.size());
  for (std::size_t v = 0; v < axes.size(); ++v) {
    if (body.segment[v] != Segment::torso)
      axes[v] = limb[static_cast<int>(body.segment[v])][body.side[v] >= 0];
    else if (posed)
      axes[v] = body.pose_from_rest[v].col(2).stableNormalized();  // image of the upright
    else
      axes[v] = trunk;
  }
  return axes;
}

SurfaceFrame surface_frame(const Vec3& normal, const Vec3& direction) {
  SurfaceFrame frame;
  const Vec3 tangent = direction - direction.dot(normal) * normal;
  const double length = tangent.norm();
  frame.has_direction = length > std::sin(kLeastInclination) * direction.norm();
  const Vec3 a = frame.has_direction ? Vec3(tangent / length) : Vec3(normal.unitOrthogonal());
  frame.axes << a.cross(normal), a, normal;
  return frame;
}

Vec3 at_point(const geometry::TriangleMesh& surface, const std::vector<Vec3>& per_vertex,
              int triangle, const Vec3& barycentric) {
  Vec3 sum = Vec3::Zero();
  for (int k = 0; k < 3; ++k) sum += barycentric[k] * per_vertex[surface.triangles[triangle][k]];
  return sum;
}

namespace {
/// Edges of a skin triangle from its first corner.
Eigen::Matrix<double, 3, 2> edges(const Body& body, int triangle) {
  const Triangle& c = body.surface.triangles[triangle];
  const auto& x = body.surface.vertices;
  Eigen::Matrix<double, 3, 2> e;
  e << x[c[1]] - x[c[0]], x[c[2]] - x[c[0]];
  return e;
}

Vec3 normal_at(const Body& body, int triangle, const Vec3& barycentric) {
  return at_point(body.surface, body.normals, triangle, barycentric).normalized();
}
}  // namespace

SkinPoint skin_point(const Body& reference, const std::vector<Vec3>& axes,
                     const geometry::ClosestPoint& at, const Vec3& otherwise) {
  const Vec3 normal = normal_at(reference, at.triangle, at.barycentric);
  const SurfaceFrame frame =
      surface_frame(normal, at_point(reference.surface, axes, at.triangle, at.barycentric));
  const Vec3 tangent = (frame.has_direction ? frame : surface_frame(normal, otherwise)).axes.col(1);
  // Least squares: the foot of the direction in the plane of the triangle.
  const Vec2 direction = geometry::least_squares(edges(reference, at.triangle), tangent);
  return {at.triangle, at.barycentric, direction, frame.has_direction};
}

Vec3 position_of(const SkinPoint& point, const Body& now) {
  return at_point(now.surface, now.surface.vertices, point.triangle, point.barycentric);
}

SurfaceFrame frame_of(const SkinPoint& point, const Body& now) {
  SurfaceFrame frame = surface_frame(normal_at(now, point.triangle, point.barycentric),
                                     edges(now, point.triangle) * point.direction);
  frame.has_direction = frame.has_direction && point.has_direction;
  return frame;
}

void require_same_wearer(const Body& reference, const Body& now) {
  if (&reference == &now) return;  // asked for every sensor: comparing meshes costs more than it
  const geometry::TriangleMesh &a = reference.surface, &b = now.surface;
  if (a.vertices.size() == b.vertices.size() && a.triangles == b.triangles) return;
  throw InvalidInput(
      "two postures of one wearer: found bodies of " + std::to_string(a.vertices.size()) + " and " +
          std::to_string(b.vertices.size()) + " vertices, expected the same surface in both",
      "a partner on the skin can only be followed on a body that keeps its mesh");
}

}  // namespace loosefit::body

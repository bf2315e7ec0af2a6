#pragma once
#include <Eigen/Geometry>
#include <functional>

#include "loosefit/body/body.h"
#include "loosefit/garment/garment.h"
#include "support/flat_garment.h"

namespace loosefit::testing {

/// A wall for a back: the line through `profile` (x, y), x falling, extruded over z = −0.5 … 0.5,
/// all normals +y. One torso with its axis upright. The frame on it is [−x, z, y].
inline body::Body wall_body(const std::vector<Vec2>& profile = {{0.5, 0}, {-0.5, 0}}) {
  body::Body body;
  for (const double z : {-0.5, 0.5})
    for (const Vec2& p : profile) body.surface.vertices.emplace_back(p.x(), p.y(), z);
  const int n = static_cast<int>(profile.size());
  for (int i = 0; i + 1 < n; ++i) {
    body.surface.triangles.push_back({i, i + 1, n + i + 1});
    body.surface.triangles.push_back({i, n + i + 1, n + i});
  }
  body.normals.assign(2 * n, Vec3::UnitY());
  body.segment.assign(2 * n, body::Segment::torso);
  body.side.assign(2 * n, 0);
  body.joints["pelvis"] = Vec3(0, -0.1, -0.4);
  body.joints["neck"] = Vec3(0, -0.1, 0.4);
  return body;
}

/// The frame on the wall: columns s, a, n.
inline Mat3 wall_frame() {
  Mat3 frame;
  frame << -Vec3::UnitX(), Vec3::UnitZ(), Vec3::UnitY();
  return frame;
}

/// A square of cloth, u and v from −size/2 to size/2, one panel "patch".
inline garment::Garment patch_garment(double size, double edge) {
  geometry::TriangleMesh flat = support::sheet(size, size, edge);
  for (Vec3& p : flat.vertices) p -= Vec3(size / 2, size / 2, 0);
  garment::Garment g;
  g.panel_names = {"patch"};
  g.vertex_count = static_cast<int>(flat.vertices.size());
  g.triangles = flat.triangles;
  g.triangle_uv = support::flat_uv(flat);
  g.triangle_panel.assign(g.triangles.size(), 0);
  for (const Vec3& p : flat.vertices) g.vertex_uv.emplace_back(p.x(), p.y());
  g.vertex_panel.assign(g.vertex_count, 0);
  g.area = size * size;
  return g;
}

/// The patch `gap` before the wall with its grain upright, its middle at (0, gap, 0), then turned
/// about its middle and moved.
inline std::vector<Vec3> before_wall(const garment::Garment& patch, double gap,
                                     const Mat3& turn = Mat3::Identity(),
                                     const Vec3& move = Vec3::Zero()) {
  std::vector<Vec3> positions;
  for (const Vec2& uv : patch.vertex_uv)
    positions.push_back(Vec3(0, gap, 0) + turn * Vec3(-uv.x(), 0, uv.y()) + move);
  return positions;
}

inline Mat3 turn_about(const Vec3& axis, double angle) {
  return Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
}

/// The body moved as a whole, skin, normals, joints and skinning.
inline body::Body moved(body::Body body, const Mat3& turn, const Vec3& move) {
  for (Vec3& p : body.surface.vertices) p = turn * p + move;
  for (Vec3& n : body.normals) n = turn * n;
  for (auto& joint : body.joints) joint.second = turn * joint.second + move;
  for (auto& pose : body.pose_from_rest) {
    pose = (turn * pose).eval();
    pose.col(3) += move;
  }
  return body;
}

inline std::vector<Vec3> moved(std::vector<Vec3> points, const Mat3& turn, const Vec3& move) {
  for (Vec3& p : points) p = turn * p + move;
  return points;
}

}  // namespace loosefit::testing

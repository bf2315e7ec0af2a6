#pragma once
#include <algorithm>
#include <string>
#include <vector>

#include "loosefit/body/body.h"
#include "loosefit/body/mesh_repair.h"
#include "loosefit/body/surface_topology.h"

// Scans of people who lack something, or that come in parts.
namespace loosefit::support {

/// Whether a point of a limb's skin lies beyond a share of the way from one joint to the next.
struct LimbCut {
  std::vector<body::Segment> beyond;  ///< that are gone as a whole
  body::Segment in;                   ///< that is cut
  std::string from, to;               ///< joints without their sides
  double share = 0;
};

inline LimbCut cut_of(body::Segment in, double share) {
  using body::Segment;
  switch (in) {
    case Segment::upper_arm:
      return {{Segment::forearm, Segment::hand}, in, "shoulder", "elbow", share};
    case Segment::forearm:
      return {{Segment::hand}, in, "elbow", "wrist", share};
    case Segment::thigh:
      return {{Segment::shank, Segment::foot}, in, "hip", "knee", share};
    default:
      return {{Segment::foot}, Segment::shank, "knee", "ankle", share};
  }
}

/// Closes every hole by a fan to its middle.
inline void close(geometry::TriangleMesh& mesh) {
  for (const body::Hole& hole : body::find_holes(mesh)) {
    const int middle = int(mesh.vertices.size());
    mesh.vertices.push_back(hole.centre);
    for (std::size_t i = 0; i < hole.rim.size(); ++i)
      mesh.triangles.push_back({hole.rim[i], hole.rim[(i + 1) % hole.rim.size()], middle});
  }
}

/// The largest piece of a surface without the triangles at vertices that are gone.
inline geometry::TriangleMesh without(geometry::TriangleMesh mesh, const std::vector<char>& gone) {
  std::erase_if(mesh.triangles, [&](const Triangle& t) {
    return gone[std::size_t(t[0])] || gone[std::size_t(t[1])] || gone[std::size_t(t[2])];
  });
  body::keep_piece(mesh, body::connected_pieces(mesh).front());
  return mesh;
}

/// The skin of a body without what lies beyond the cut of a limb on one side (+1 left, -1 right),
/// closed there.
inline geometry::TriangleMesh cut_limb(const body::Body& body, const LimbCut& cut, int side) {
  const std::string end = side > 0 ? "_L" : "_R";
  const Vec3 from = body.joints.at(cut.from + end), way = body.joints.at(cut.to + end) - from;
  std::vector<char> gone(body.segment.size(), 0);
  for (std::size_t v = 0; v < gone.size(); ++v) {
    if (body.side[v] != side) continue;
    const bool beyond = (body.surface.vertices[v] - from).dot(way) > cut.share * way.squaredNorm();
    gone[v] = std::ranges::count(cut.beyond, body.segment[v]) > 0 ||
              (body.segment[v] == cut.in && beyond);
  }
  geometry::TriangleMesh mesh = without(body.surface, gone);
  close(mesh);
  return mesh;
}

/// The skin of a body without some parts, closed there.
inline geometry::TriangleMesh without_segments(const body::Body& body,
                                               const std::vector<body::Segment>& parts) {
  std::vector<char> gone(body.segment.size(), 0);
  for (std::size_t v = 0; v < gone.size(); ++v)
    gone[v] = std::ranges::count(parts, body.segment[v]);
  geometry::TriangleMesh mesh = without(body.surface, gone);
  close(mesh);
  return mesh;
}

/// Several surfaces as one list of triangles.
inline geometry::TriangleMesh together(const std::vector<geometry::TriangleMesh>& parts) {
  geometry::TriangleMesh all;
  for (const geometry::TriangleMesh& part : parts) {
    const int base = int(all.vertices.size());
    all.vertices.insert(all.vertices.end(), part.vertices.begin(), part.vertices.end());
    for (const Triangle& t : part.triangles)
      all.triangles.push_back({t[0] + base, t[1] + base, t[2] + base});
  }
  return all;
}

/// Head with trunk, both arms and both legs as surfaces of their own: the triangles whose middles
/// lie on one side of the cuts, without `rows` rows of triangles along them; open or closed.
inline std::vector<geometry::TriangleMesh> in_parts(const body::Body& body, int rows, bool closed) {
  using body::Segment;
  std::vector<int> part_of(body.segment.size(), 0);
  for (std::size_t v = 0; v < part_of.size(); ++v) {
    const Segment s = body.segment[v];
    const bool arm = s == Segment::forearm || s == Segment::hand;
    const bool leg = s == Segment::shank || s == Segment::foot;
    if (arm || leg) part_of[v] = (arm ? 1 : 3) + (body.side[v] > 0 ? 0 : 1);
  }
  std::vector<char> gone(part_of.size(), 0);
  for (int row = 0; row < rows; ++row) {
    const std::vector<char> before = gone;
    for (const Triangle& t : body.surface.triangles)
      for (const int a : t)
        for (const int b : t)
          if (part_of[std::size_t(a)] != part_of[std::size_t(b)] ||
              (before[std::size_t(b)] && part_of[std::size_t(a)] == 0))
            gone[std::size_t(a)] = 1;
  }
  std::vector<geometry::TriangleMesh> parts;
  for (int part = 0; part < 5; ++part) {
    std::vector<char> other = gone;
    for (std::size_t v = 0; v < other.size(); ++v)
      if (part_of[v] != part) other[v] = 1;
    parts.push_back(without(body.surface, other));
    if (closed) close(parts.back());
  }
  return parts;
}

}  // namespace loosefit::support

#include "loosefit/placement/footprint_unfold.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <queue>
#include <set>

#include "loosefit/geometry/closest_point.h"
#include "loosefit/geometry/flat_triangle.h"
#include "loosefit/geometry/mesh_topology.h"

namespace loosefit::placement {
namespace {

Vec3 lifted(const Vec2& p) { return {p.x(), p.y(), 0}; }

double distance(const std::array<Vec2, 3>& corners, const Vec2& p) {
  const Vec3 a = lifted(corners[0]), b = lifted(corners[1]), c = lifted(corners[2]);
  const Vec3 w = geometry::closest_barycentric(lifted(p), a, b, c);
  return (w[0] * a + w[1] * b + w[2] * c - lifted(p)).norm();
}

/// Rigid map of a piece into the plane: turn (and turning over), then shift.
struct Layout {
  Mat2 turn = Mat2::Identity();
  Vec2 shift = Vec2::Zero();
  Vec2 operator()(const Vec2& p) const { return turn * p + shift; }
};

/// Turn of a neighbour whose edge from → to must come to lie on a → b, its third corner `apex` on
/// the other side of it than `inner`.
Mat2 turn_against(const Vec2& a, const Vec2& b, const Vec2& inner, const Vec2& from, const Vec2& to,
                  const Vec2& apex) {
  const Vec2 target = (b - a).normalized(), has = (to - from).normalized();
  const double c = target.dot(has), s = geometry::cross(has, target);
  Mat2 turn;
  turn << c, -s, s, c;
  // Turned on, the neighbour would cover this piece: a right-to-wrong seam. Turn it over first.
  if ((geometry::cross(to - from, apex - from) > 0) == (geometry::cross(b - a, inner - a) > 0))
    turn *= 2 * has * has.transpose() - Mat2::Identity();
  return turn;
}

}  // namespace

Vec3 weights_in(const std::array<Vec2, 3>& corners, const Vec2& p) {
  const Vec2 a = corners[1] - corners[0], b = corners[2] - corners[0], d = p - corners[0];
  const double whole = geometry::cross(a, b);
  const double second = geometry::cross(d, b) / whole, third = geometry::cross(a, d) / whole;
  return {1 - second - third, second, third};
}

TriangleNeighbours triangle_neighbours(const garment::Garment& garment) {
  const geometry::MeshTopology topology(garment.triangles);
  TriangleNeighbours beyond(garment.triangles.size(), {-1, -1, -1});
  for (int e = 0; e < topology.edge_count(); ++e) {
    const auto sides = topology.sides(e);
    for (std::size_t i = 0; i + 1 < sides.size(); ++i) {
      beyond[sides[i].triangle][sides[i].corner] = sides[i + 1].triangle;
      beyond[sides[i + 1].triangle][sides[i + 1].corner] = sides[i].triangle;
    }
  }
  return beyond;
}

AcrossEdge across_edge(const garment::Garment& garment, int triangle, int k, int next) {
  const Triangle &ids = garment.triangles[triangle], &other = garment.triangles[next];
  const auto corner = [&](int vertex) {
    return static_cast<int>(std::find(other.begin(), other.end(), vertex) - other.begin());
  };
  const auto &here = garment.triangle_uv[triangle], &there = garment.triangle_uv[next];
  const Vec2 &a = here[k], &b = here[(k + 1) % 3];
  AcrossEdge across;
  across.ends = {corner(ids[k]), corner(ids[(k + 1) % 3])};
  const Vec2 &from = there[across.ends[0]], &to = there[across.ends[1]];
  across.seam = garment.triangle_panel[next] != garment.triangle_panel[triangle] ||
                (from - a).norm() > 1e-9 || (to - b).norm() > 1e-9;
  if (across.seam)
    across.turn =
        turn_against(a, b, here[(k + 2) % 3], from, to, there[3 - across.ends[0] - across.ends[1]]);
  return across;
}

std::vector<FlatTriangle> unfold(const garment::Garment& garment, int triangle, const Vec2& centre,
                                 double reach, const TriangleNeighbours* neighbours) {
  // The neighbours may be given, since many footprints share one garment.
  TriangleNeighbours own;
  if (!neighbours) own = triangle_neighbours(garment);
  const TriangleNeighbours& beyond = neighbours ? *neighbours : own;
  // Triangles to visit, nearest first; equal distances by number, so that the order is unique.
  struct Step {
    double distance;
    int triangle;
    Layout layout;
    bool operator>(const Step& other) const {
      return std::tie(distance, triangle) > std::tie(other.distance, other.triangle);
    }
  };
  std::priority_queue<Step, std::vector<Step>, std::greater<>> open;
  open.push({0, triangle, {}});
  std::set<int> done;
  std::vector<FlatTriangle> found;
  while (!open.empty()) {
    const Step step = open.top();
    open.pop();
    if (!done.insert(step.triangle).second) continue;
    // Nearest triangle next, laid flat by the layout of the path that leads to it.
    FlatTriangle flat{step.triangle, {}};
    for (int k = 0; k < 3; ++k)
      flat.corners[k] = step.layout(garment.triangle_uv[step.triangle][k]);
    found.push_back(flat);
    for (int k = 0; k < 3; ++k) {
      // Its neighbours: within a panel the layout goes on, across a seam the panel is turned and
      // shifted so that the shared edges meet.
      const int next = beyond[step.triangle][k];
      if (next < 0 || done.count(next)) continue;
      const AcrossEdge across = across_edge(garment, step.triangle, k, next);
      const auto& uv = garment.triangle_uv[next];
      Layout layout = step.layout;
      if (across.seam) {
        layout.turn *= across.turn;
        layout.shift = (flat.corners[k] + flat.corners[(k + 1) % 3]) / 2 -
                       layout.turn * (uv[across.ends[0]] + uv[across.ends[1]]) / 2;
      }
      // Only what comes within reach of the centre is followed.
      std::array<Vec2, 3> corners;
      for (int c = 0; c < 3; ++c) corners[c] = layout(uv[c]);
      const double d = distance(corners, centre);
      if (d <= reach) open.push({d, next, layout});
    }
  }
  return found;
}

}  // namespace loosefit::placement

#include "loosefit/body/section.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cstdint>
#include <utility>

namespace loosefit::body {
namespace {

// A crossing of a mesh edge by the plane, and the two triangles' cut segments that meet there.
struct Crossing {
  std::uint64_t edge = 0;
  int segment = 0;
  int end = 0;
};

struct Segment {
  std::uint64_t from = 0, to = 0;  ///< edge keys
};

std::uint64_t edge_key(int a, int b) {
  const auto [low, high] = std::minmax(a, b);
  return std::uint64_t(std::uint32_t(low)) << 32 | std::uint32_t(high);
}

std::pair<Vec3, Vec3> plane_axes(const Vec3& normal) {
  const Vec3 other = std::abs(normal.x()) < 0.8 * normal.norm() ? Vec3::UnitX() : Vec3::UnitY();
  const Vec3 u = normal.cross(other).normalized();
  return {u, normal.cross(u).normalized()};
}

double cross(const Vec2& o, const Vec2& a, const Vec2& b) {
  return (a - o).x() * (b - o).y() - (a - o).y() * (b - o).x();
}

std::vector<double> heights(const geometry::TriangleMesh& mesh, const Vec3& origin,
                            const Vec3& normal) {
  const Vec3 n = normal.normalized();
  const double offset = n.dot(origin);
  std::vector<double> height(mesh.vertices.size());
  for (std::size_t v = 0; v < height.size(); ++v) height[v] = n.dot(mesh.vertices[v]) - offset;
  return height;
}

/// All segments along which a scalar per vertex is zero, and how they join.
class Cut {
 public:
  Cut(const geometry::TriangleMesh& mesh, const std::vector<double>& height)
      : mesh_(mesh), height_(height) {
    const auto above = [&](int v) { return height[std::size_t(v)] >= 0; };
    // One segment for every triangle that the level cuts, from cut edge to cut edge.
    std::vector<Crossing> crossings;
    for (const auto& t : mesh.triangles) {
      if (above(t[0]) == above(t[1]) && above(t[1]) == above(t[2])) continue;
      // The corner alone on its side; its two edges are cut.
      std::size_t lone = 0;
      while (above(t[lone]) == above(t[(lone + 1) % 3]) ||
             above(t[lone]) == above(t[(lone + 2) % 3])) {
        ++lone;
      }
      const int a = t[lone], b = t[(lone + 1) % 3], c = t[(lone + 2) % 3];
      const int index = int(segments_.size());
      segments_.push_back({edge_key(a, b), edge_key(a, c)});
      crossings.push_back({segments_.back().from, index, 0});
      crossings.push_back({segments_.back().to, index, 1});
    }
    std::sort(crossings.begin(), crossings.end(), [](const Crossing& l, const Crossing& r) {
      return std::pair(l.edge, l.segment) < std::pair(r.edge, r.segment);
    });
    neighbour_.assign(segments_.size(), {-1, -1});
    for (std::size_t i = 0; i + 1 < crossings.size(); ++i) {
      if (crossings[i].edge != crossings[i + 1].edge) continue;
      neighbour_[std::size_t(crossings[i].segment)][std::size_t(crossings[i].end)] =
          crossings[i + 1].segment;
      neighbour_[std::size_t(crossings[i + 1].segment)][std::size_t(crossings[i + 1].end)] =
          crossings[i].segment;
      ++i;
    }
    used_.assign(segments_.size(), 0);
  }

  std::size_t size() const { return segments_.size(); }
  bool used(std::size_t segment) const { return used_[segment]; }
  bool ends(std::size_t segment, std::size_t end) const { return neighbour_[segment][end] < 0; }

  /// From segment to segment, out of `first` by its end `leave`, until the loop closes, which it
  /// returns true for, or nothing follows.
  bool follow(std::size_t first, std::size_t leave, SectionLoop& loop) {
    std::size_t at = first;
    while (true) {
      used_[at] = 1;
      const std::uint64_t edge = edge_of(at, leave);
      add(edge, loop);
      const int next = neighbour_[at][leave];
      if (next < 0) return false;
      if (std::size_t(next) == first) return true;
      if (used_[std::size_t(next)]) return false;
      at = std::size_t(next);
      leave = segments_[at].from == edge ? 1 : 0;
    }
  }
  std::uint64_t edge_of(std::size_t segment, std::size_t end) const {
    return end == 1 ? segments_[segment].to : segments_[segment].from;
  }
  /// Where an edge is cut, linearly between its ends.
  void add(std::uint64_t edge, SectionLoop& loop) const {
    const auto a = std::size_t(edge >> 32), b = std::size_t(edge & 0xffffffff);
    const double share = height_[a] / (height_[a] - height_[b]);
    loop.points.push_back(mesh_.vertices[a] + share * (mesh_.vertices[b] - mesh_.vertices[a]));
    loop.edges.push_back({int(edge >> 32), int(edge & 0xffffffff)});
  }

 private:
  const geometry::TriangleMesh& mesh_;
  const std::vector<double>& height_;
  std::vector<Segment> segments_;
  std::vector<std::array<int, 2>> neighbour_;  ///< by end: the segment that shares it, or -1
  std::vector<char> used_;
};

}  // namespace

std::vector<SectionLoop> plane_section(const geometry::TriangleMesh& mesh, const Vec3& origin,
                                       const Vec3& normal) {
  return level_section(mesh, heights(mesh, origin, normal), 0);
}

std::vector<SectionLoop> level_section(const geometry::TriangleMesh& mesh,
                                       const std::vector<double>& values, double level) {
  std::vector<double> height = values;
  for (double& h : height) h -= level;
  Cut cut(mesh, height);
  std::vector<SectionLoop> loops;
  for (std::size_t first = 0; first < cut.size(); ++first) {
    if (cut.used(first)) continue;
    SectionLoop loop;
    // Its length as a polygon; open chains are dropped.
    if (!cut.follow(first, 1, loop) || loop.points.size() < 3) continue;
    for (std::size_t i = 0; i < loop.points.size(); ++i) {
      loop.length += (loop.points[(i + 1) % loop.points.size()] - loop.points[i]).norm();
    }
    loops.push_back(std::move(loop));
  }
  return loops;
}

std::vector<SectionLoop> open_chains(const geometry::TriangleMesh& mesh, const Vec3& origin,
                                     const Vec3& normal) {
  const std::vector<double> height = heights(mesh, origin, normal);
  Cut cut(mesh, height);
  std::vector<SectionLoop> chains;
  for (std::size_t first = 0; first < cut.size(); ++first) {
    if (cut.used(first)) continue;
    const bool begins = cut.ends(first, 0);
    if (!begins && !cut.ends(first, 1)) continue;
    SectionLoop chain;
    const std::size_t leave = begins ? 1 : 0;
    cut.add(cut.edge_of(first, 1 - leave), chain);
    cut.follow(first, leave, chain);
    for (std::size_t i = 0; i + 1 < chain.points.size(); ++i)
      chain.length += (chain.points[i + 1] - chain.points[i]).norm();
    chains.push_back(std::move(chain));
  }
  return chains;
}

bool loop_contains(const SectionLoop& loop, const Vec3& normal, const Vec3& point) {
  const auto [u, v] = plane_axes(normal);
  const Vec2 p(u.dot(point), v.dot(point));
  bool inside = false;
  for (std::size_t i = 0; i < loop.points.size(); ++i) {
    const Vec3& a3 = loop.points[i];
    const Vec3& b3 = loop.points[(i + 1) % loop.points.size()];
    const Vec2 a(u.dot(a3), v.dot(a3)), b(u.dot(b3), v.dot(b3));
    if ((a.y() > p.y()) != (b.y() > p.y()) &&
        p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) {
      inside = !inside;
    }
  }
  return inside;
}

std::vector<Vec2> convex_hull(std::vector<Vec2> points) {
  std::sort(points.begin(), points.end(), [](const Vec2& a, const Vec2& b) {
    return std::pair(a.x(), a.y()) < std::pair(b.x(), b.y());
  });
  std::vector<Vec2> hull;
  for (int pass = 0; pass < 2; ++pass) {
    const std::size_t floor = hull.size();
    for (const auto& p : points) {
      while (hull.size() >= floor + 2 && cross(hull[hull.size() - 2], hull.back(), p) <= 0) {
        hull.pop_back();
      }
      hull.push_back(p);
    }
    if (!hull.empty()) hull.pop_back();  // the next pass starts here
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

double hull_perimeter(const std::vector<Vec3>& points, const Vec3& normal) {
  const auto [u, v] = plane_axes(normal);
  std::vector<Vec2> flat;
  for (const auto& p : points) flat.emplace_back(u.dot(p), v.dot(p));
  const auto hull = convex_hull(std::move(flat));
  double length = 0;
  for (std::size_t i = 0; i < hull.size(); ++i)
    length += (hull[(i + 1) % hull.size()] - hull[i]).norm();
  return length;
}

const SectionLoop* trunk_loop(const std::vector<SectionLoop>& loops, double x) {
  const SectionLoop* best = nullptr;
  for (const auto& loop : loops) {
    const auto [low, high] =
        std::minmax_element(loop.points.begin(), loop.points.end(),
                            [](const Vec3& a, const Vec3& b) { return a.x() < b.x(); });
    if (low->x() <= x && x <= high->x() && (!best || loop.length > best->length)) best = &loop;
  }
  return best;
}

Vec3 centroid(const SectionLoop& loop) {
  Vec3 sum = Vec3::Zero();
  double length = 0;
  for (std::size_t i = 0; i < loop.points.size(); ++i) {
    const Vec3& a = loop.points[i];
    const Vec3& b = loop.points[(i + 1) % loop.points.size()];
    sum += (b - a).norm() * 0.5 * (a + b);
    length += (b - a).norm();
  }
  return length > 0 ? Vec3(sum / length) : loop.points[0];
}

}  // namespace loosefit::body

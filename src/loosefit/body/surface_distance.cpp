#include "loosefit/body/surface_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <utility>

namespace loosefit::body {
namespace {

// Distance of c from a source that is `from_a` away from a and `from_b` from b, straight through
// the edge ab; where the straight way misses the edge, along one of the sides.
double through_edge(const Vec3& a, double from_a, const Vec3& b, double from_b, const Vec3& c) {
  const double round = std::min(from_a + (c - a).norm(), from_b + (c - b).norm());
  const double edge = (b - a).norm();
  if (!(edge > 0)) return round;
  const Vec3 along = (b - a) / edge;
  const double source_x = (from_a * from_a - from_b * from_b + edge * edge) / (2 * edge);
  const double below = from_a * from_a - source_x * source_x;
  if (below < 0) return round;
  const double source_y = -std::sqrt(below);
  const double x = along.dot(c - a);
  const double y = (c - a - x * along).norm();
  const double crossing = source_x + (x - source_x) * -source_y / (y - source_y);
  if (!(crossing >= 0 && crossing <= edge)) return round;
  return std::max({std::hypot(x - source_x, y - source_y), from_a, from_b});
}

}  // namespace

std::vector<std::vector<int>> neighbours_of(const geometry::TriangleMesh& mesh) {
  std::vector<std::vector<int>> near(mesh.vertices.size());
  for (const auto& t : mesh.triangles) {
    for (std::size_t c = 0; c < 3; ++c) {
      near[std::size_t(t[c])].push_back(t[(c + 1) % 3]);
      near[std::size_t(t[c])].push_back(t[(c + 2) % 3]);
    }
  }
  for (auto& list : near) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
  return near;
}

std::vector<double> surface_distance(const geometry::TriangleMesh& mesh,
                                     const std::vector<int>& sources) {
  // Triangles at every vertex.
  std::vector<std::vector<int>> triangles_at(mesh.vertices.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (const int v : mesh.triangles[t]) triangles_at[std::size_t(v)].push_back(int(t));
  }
  // Vertices become final in the order of their distance, as in Dijkstra's method.
  std::vector<double> distance(mesh.vertices.size(), std::numeric_limits<double>::infinity());
  std::vector<char> done(mesh.vertices.size(), 0);
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> front;
  for (const int source : sources) {
    distance[std::size_t(source)] = 0;
    front.push({0, source});
  }
  const auto point = [&](int v) -> const Vec3& { return mesh.vertices[std::size_t(v)]; };
  const auto offer = [&](int v, double d) {
    if (done[std::size_t(v)] || d >= distance[std::size_t(v)]) return;
    distance[std::size_t(v)] = d;
    front.push({d, v});
  };
  while (!front.empty()) {
    const auto [d, v] = front.top();
    front.pop();
    if (done[std::size_t(v)]) continue;
    done[std::size_t(v)] = 1;
    // A triangle with two final corners carries a straight front to the third; with one, the edge
    // is the way.
    for (const int t : triangles_at[std::size_t(v)]) {
      const Triangle& corners = mesh.triangles[std::size_t(t)];
      for (std::size_t c = 0; c < 3; ++c) {
        if (corners[c] != v) continue;
        const int p = corners[(c + 1) % 3], q = corners[(c + 2) % 3];
        for (const auto& [settled, other] : {std::pair(p, q), std::pair(q, p)}) {
          if (done[std::size_t(settled)])
            offer(other, through_edge(point(v), d, point(settled), distance[std::size_t(settled)],
                                      point(other)));
          else
            offer(settled, d + (point(settled) - point(v)).norm());
        }
      }
    }
  }
  return distance;
}

}  // namespace loosefit::body

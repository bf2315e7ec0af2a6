#include "loosefit/geometry/mesh_topology.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include "loosefit/base/check.h"

namespace loosefit::geometry {

MeshTopology::MeshTopology(std::vector<Triangle> triangles)
    : triangles_(std::move(triangles)), edge_of_(triangles_.size()) {
  // Sides sorted into buckets by the lower vertex of their edge: faster than sorting them at once.
  struct Half {
    int other, triangle, corner;
  };
  int vertices = 0;
  for (const Triangle& t : triangles_)
    vertices = std::max({vertices, t[0] + 1, t[1] + 1, t[2] + 1});
  std::vector<int> start(vertices + 1, 0);
  for (const Triangle& t : triangles_)
    for (int k = 0; k < 3; ++k) ++start[std::min(t[k], t[(k + 1) % 3]) + 1];
  for (int v = 0; v < vertices; ++v) start[v + 1] += start[v];
  std::vector<Half> halves(3 * triangles_.size());
  std::vector<int> next(start.begin(), start.end() - 1);
  for (int i = 0; i < static_cast<int>(triangles_.size()); ++i)
    for (int k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax(triangles_[i][k], triangles_[i][(k + 1) % 3]);
      halves[next[low]++] = {high, i, k};
    }
  // Within a bucket by the other vertex, then triangle: halves of one edge come together.
  sides_.reserve(halves.size());
  for (int v = 0; v < vertices; ++v) {
    first_edge_.push_back(edge_count());
    const auto begin = halves.begin() + start[v], end = halves.begin() + start[v + 1];
    std::sort(begin, end, [](const Half& a, const Half& b) {
      return std::tie(a.other, a.triangle, a.corner) < std::tie(b.other, b.triangle, b.corner);
    });
    for (auto half = begin; half != end; ++half) {
      if (half == begin || half->other != (half - 1)->other) {
        edges_.push_back({v, half->other});
        first_side_.push_back(static_cast<int>(sides_.size()));
      }
      edge_of_[half->triangle][half->corner] = edge_count() - 1;
      sides_.push_back({half->triangle, half->corner});
    }
  }
  first_edge_.push_back(edge_count());
  first_side_.push_back(static_cast<int>(sides_.size()));
}

int MeshTopology::find(int a, int b) const {
  const auto [low, high] = std::minmax(a, b);
  if (low < 0 || low + 1 >= static_cast<int>(first_edge_.size())) return -1;
  const auto begin = edges_.begin() + first_edge_[low], end = edges_.begin() + first_edge_[low + 1];
  const auto found = std::lower_bound(begin, end, Edge{low, high});
  return found != end && (*found)[1] == high ? static_cast<int>(found - edges_.begin()) : -1;
}

std::vector<std::vector<int>> MeshTopology::vertex_neighbours() const {
  std::vector<std::vector<int>> neighbours(first_edge_.size() - 1);
  // Ascending edges give the lower neighbours of a vertex first, each kind ascending.
  for (const auto& [low, high] : edges_) neighbours[high].push_back(low);
  for (const auto& [low, high] : edges_) neighbours[low].push_back(high);
  return neighbours;
}

std::vector<std::vector<int>> MeshTopology::boundary_loops() const {
  std::vector<std::pair<int, int>> border;
  for (int e = 0; e < edge_count(); ++e)
    if (sides(e).size() == 2)
      LOOSEFIT_ASSERT(triangles_[sides(e)[0].triangle][sides(e)[0].corner] !=
                      triangles_[sides(e)[1].triangle][sides(e)[1].corner]);
    else if (sides(e).size() == 1) {
      const auto& [t, k] = sides(e)[0];
      border.emplace_back(triangles_[t][k], triangles_[t][(k + 1) % 3]);
    }
  std::sort(border.begin(), border.end());
  std::multimap<int, int> next(border.begin(), border.end());  // two where borders meet in a vertex
  std::vector<std::vector<int>> loops;
  while (!next.empty()) {
    std::vector<int>& loop = loops.emplace_back();
    for (auto at = next.begin(); at != next.end();) {
      loop.push_back(at->first);
      const int to = at->second;
      next.erase(at);
      at = to == loop.front() ? next.end() : next.find(to);
    }
  }
  return loops;
}

}  // namespace loosefit::geometry

#include "loosefit/drape/hem_hang.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

#include "loosefit/base/quantile.h"
#include "loosefit/garment/flat_lengths.h"
#include "loosefit/geometry/mesh_topology.h"

namespace loosefit::drape {

double hang_straightness(const garment::Garment& garment, const std::vector<int>& neck,
                         const std::vector<int>& hem, const std::vector<Vec3>& x) {
  const geometry::MeshTopology topology(garment.triangles);
  const std::vector<double> lengths = garment::flat_lengths(garment, topology);
  const std::vector<std::vector<int>> neighbours = topology.vertex_neighbours();
  std::vector<double> way(x.size(), std::numeric_limits<double>::infinity());
  std::vector<int> origin(x.size(), -1);  // vertex of the neck that a way begins at
  // Dijkstra's method from all vertices of the neck at once.
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> front;
  for (int v : neck) {
    way[v] = 0, origin[v] = v;
    front.emplace(0, v);
  }
  while (!front.empty()) {
    const auto [so_far, v] = front.top();
    front.pop();
    if (so_far > way[v]) continue;
    for (int next : neighbours[v]) {
      const double there = so_far + lengths[topology.find(v, next)];
      if (there >= way[next]) continue;
      way[next] = there, origin[next] = origin[v];
      front.emplace(there, next);
    }
  }
  std::vector<double> shares;
  for (int v : hem)
    if (origin[v] >= 0 && way[v] > 0) shares.push_back((x[v] - x[origin[v]]).norm() / way[v]);
  return shares.empty() ? 1 : quantile(std::move(shares), 0.25);
}

}  // namespace loosefit::drape

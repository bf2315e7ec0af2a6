#include "loosefit/drape/tube_rings.h"

#include <algorithm>
#include <set>

#include "loosefit/base/check.h"
#include "loosefit/garment/flat_lengths.h"
#include "loosefit/geometry/mesh_topology.h"

namespace loosefit::drape {
namespace {

/// Steps over edges from the opening to each vertex.
std::vector<int> steps_from(const garment::Garment& garment, const geometry::MeshTopology& topology,
                            const std::vector<int>& opening) {
  const auto next = topology.vertex_neighbours();
  std::vector<int> steps(garment.vertex_count, -1), front = opening;
  for (int v : front) steps[v] = 0;
  for (int k = 1; !front.empty(); ++k) {
    std::vector<int> reached;
    for (int v : front)
      for (int to : next[v])
        if (steps[to] < 0) steps[to] = k, reached.push_back(to);
    front = std::move(reached);
  }
  return steps;
}

}  // namespace

std::vector<std::vector<int>> tube_rings(const garment::Garment& garment,
                                         const std::vector<int>& opening, double widest) {
  const geometry::MeshTopology topology(garment.triangles);
  const std::vector<int> steps = steps_from(garment, topology, opening);
  const std::vector<double> flat = garment::flat_lengths(garment, topology);
  std::set<int> other_rims;
  for (const std::vector<int>& loop : topology.boundary_loops())
    if (std::find(loop.begin(), loop.end(), opening.front()) == loop.end())
      other_rims.insert(loop.begin(), loop.end());

  const int farthest = *std::max_element(steps.begin(), steps.end());
  std::vector<std::vector<int>> rings;
  for (int reach = 1; reach < farthest; ++reach) {
    const auto in = [&](int v) { return steps[v] >= 0 && steps[v] <= reach; };
    std::vector<Triangle> band;
    for (const Triangle& t : garment.triangles)
      if (in(t[0]) && in(t[1]) && in(t[2])) band.push_back(t);
    std::vector<int> far;
    int rims = 0;
    double length = 0;
    for (const std::vector<int>& loop : geometry::MeshTopology(band).boundary_loops()) {
      if (steps[loop.front()] == 0 && steps[loop.back()] == 0) continue;
      ++rims;
      for (std::size_t i = 0; i < loop.size(); ++i) {
        if (other_rims.count(loop[i])) return rings;
        const int edge = topology.find(loop[i], loop[(i + 1) % loop.size()]);
        require(edge >= 0, "a ring of a tube runs along edges of the garment");
        length += flat[edge];
      }
      far = loop;
    }
    if (length > widest) return rings;
    if (rims == 1) rings.push_back(far);  // a corner that is cut off makes two
  }
  return rings;
}

}  // namespace loosefit::drape

#include "loosefit/validate/trunk_hem.h"

#include <algorithm>
#include <cmath>

#include "loosefit/base/error.h"
#include "loosefit/geometry/mesh_topology.h"

namespace loosefit::validate {
namespace {

constexpr double kShortest = 0.6;          ///< of a hem of the trunk [m]
constexpr double kSector = radians(25.0);  ///< of the hem to either side of a place

}  // namespace

std::vector<int> trunk_hem(const garment::Garment& mesh, const std::vector<Vec3>& x) {
  const geometry::MeshTopology topology(mesh.triangles);
  std::vector<int> hem;
  double lowest = HUGE_VAL;
  for (const std::vector<int>& loop : topology.boundary_loops()) {
    double low = HUGE_VAL;
    double length = 0;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      low = std::min(low, x[loop[i]].z());
      length += (x[loop[i]] - x[loop[(i + 1) % loop.size()]]).norm();
    }
    if (length > kShortest && low < lowest) lowest = low, hem = loop;
  }
  return hem;
}

HemHeights hem_means(const std::vector<int>& hem, const std::vector<Vec3>& x,
                     const std::vector<double>& value) {
  Vec3 middle = Vec3::Zero();
  for (int v : hem) middle += x[v] / static_cast<double>(hem.size());
  const std::array<Vec2, kHemPlaces> places = {Vec2(-1, 0), Vec2(0, -1), Vec2(0, 1), Vec2(1, 0)};
  HemHeights means = {};
  std::array<int, kHemPlaces> counts = {};
  for (int v : hem) {
    const Vec2 off = (x[v] - middle).head<2>().normalized();
    for (int k = 0; k < kHemPlaces; ++k)
      if (off.dot(places[k]) > std::cos(kSector)) means[k] += value[v], ++counts[k];
  }
  if (*std::ranges::min_element(counts) == 0)
    throw SolverFailure("the garment has no hem round the trunk");
  for (int k = 0; k < kHemPlaces; ++k) means[k] /= counts[k];
  return means;
}

}  // namespace loosefit::validate

#include "loosefit/drape/raise_offsets.h"

#include <algorithm>

#include "loosefit/geometry/exact_intersection.h"

namespace loosefit::drape {

std::set<int> penetrating_triangles(const ClothMesh& cloth, const body::PosedBody& body,
                                    const std::vector<Vec3>& x) {
  std::set<int> cut;
  for (const auto& [t, s] : geometry::mesh_intersections(x, cloth.triangles, body.tree()))
    cut.insert(t);
  return cut;
}

void raise_offsets_at_penetrations(ClothModel& model, double farthest,
                                   const std::set<int>& penetrating, std::map<int, int>& times_cut,
                                   const PenetrationTuning& tuning) {
  const ClothMesh& cloth = model.mesh();
  std::vector<std::map<int, double>> raise(cloth.layers());  // point → [m]
  for (int t : penetrating) {
    const int layer = cloth.triangle_layer[t];
    const double by = tuning.clearance + tuning.clearance_each_time * times_cut[t]++;
    for (int p : model.lattice(layer).points_of(t - cloth.first_triangle[layer]))
      raise[layer][p] = std::max(raise[layer][p], by);
  }
  for (int layer = 0; layer < cloth.layers(); ++layer) {
    std::vector<contact::ContactPoint>& points = model.body(layer).change_points();
    for (const auto& [p, by] : raise[layer])
      points[p].offset = std::max(points[p].offset, std::min(farthest, points[p].offset + by));
  }
}

}  // namespace loosefit::drape

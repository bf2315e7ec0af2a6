#include "loosefit/drape/raise_offsets.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "loosefit/geometry/exact_intersection.h"

namespace loosefit::drape {

std::set<int> penetrating_triangles(const ClothMesh& cloth, const body::PosedBody& body,
                                    const std::vector<Vec3>& x) {
  std::set<int> cut;
  for (const auto& [t, s] : geometry::mesh_intersections(x, cloth.triangles, body.tree()))
    cut.insert(t);
  return cut;
}

namespace {

/// Exact distance of every contact point to the skin [m]; `far` where the field reads more.
std::vector<double> distances(const contact::BodyContact& contact, const ContactBody& body,
                              const std::vector<Vec3>& x, const PenetrationTuning& tuning) {
  const std::vector<contact::ContactPoint>& points = contact.points();
  std::vector<double> distance(points.size(), tuning.far);
  tbb::parallel_for(std::size_t{0}, points.size(), [&](std::size_t i) {
    const double seen = contact.field_distance(points[i], x, tuning.far);
    if (seen < tuning.far)
      distance[i] = body.field->exact_distance(points[i].position(x),
                                               std::abs(seen) + tuning.largest_field_error);
  });
  return distance;
}

}  // namespace

void raise_offsets_at_penetrations(ClothModel& model, const ContactBody& body,
                                   const std::vector<Vec3>& x, const std::set<int>& penetrating,
                                   std::map<int, int>& times_cut, const PenetrationTuning& tuning) {
  const ClothMesh& cloth = model.mesh();
  const double farthest = body.field->smooth_reach();
  for (int layer = 0; layer < cloth.layers(); ++layer) {
    contact::BodyContact& contact = model.body(layer);
    const contact::ContactLattice& lattice = model.lattice(layer);
    const std::vector<double> distance = distances(contact, body, x, tuning);
    std::map<int, double> raise;  // point → [m]
    for (int t = cloth.first_triangle[layer]; t < cloth.first_triangle[layer + 1]; ++t) {
      const int own = t - cloth.first_triangle[layer];
      const bool cuts = penetrating.count(t) > 0;
      if (!cuts && !lattice.is_refined(own)) continue;
      const std::vector<int> points = lattice.points_of(own);
      double least = tuning.far;
      for (int p : points) least = std::min(least, distance[p]);
      if (!cuts && least >= tuning.near_penetration) continue;
      const double by = std::clamp(tuning.clearance - least, 0.0, tuning.largest_raise) +
                        tuning.clearance_each_time * ++times_cut[t];
      for (int p : points) raise[p] = std::max(raise[p], by);
    }
    std::vector<contact::ContactPoint>& points = contact.change_points();
    for (const auto& [p, by] : raise)
      points[p].offset = std::max(points[p].offset, std::min(farthest, points[p].offset + by));
  }
}

}  // namespace loosefit::drape

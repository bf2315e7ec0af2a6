#include "loosefit/drape/raise_offsets.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "loosefit/geometry/closest_point_tree.h"
#include "loosefit/geometry/exact_intersection.h"

namespace loosefit::drape {
namespace {

/// Intervals along an edge of the triangle.
int lattice_intervals(const Triangle& t, const std::vector<Vec3>& x,
                      const PenetrationTuning& tuning) {
  double longest = 0;
  for (int k = 0; k < 3; ++k) longest = std::max(longest, (x[t[k]] - x[t[(k + 1) % 3]]).norm());
  return std::max(tuning.least_lattice,
                  static_cast<int>(std::ceil(longest / tuning.lattice_spacing)));
}

/// visit(p) for the points of a lattice over the triangle until that says false; true if it never
/// did.
template <class Visit>
bool visit_lattice(const Triangle& t, const std::vector<Vec3>& x, const PenetrationTuning& tuning,
                   const Visit& visit) {
  const int n = lattice_intervals(t, x, tuning);
  for (int i = 0; i <= n; ++i)
    for (int j = 0; i + j <= n; ++j) {
      const double a = double(i) / n, b = double(j) / n;
      const Vec3 p = a * x[t[0]] + b * x[t[1]] + (1 - a - b) * x[t[2]];
      if (!visit(p)) return false;
    }
  return true;
}

/// Least signed distance to the skin of a lattice over the triangle [m]; `corner`: of its first
/// one.
double least_distance(const geometry::ClosestPointTree& skin, const Triangle& t,
                      const std::vector<Vec3>& x, double corner, const PenetrationTuning& tuning) {
  double least = tuning.far;
  visit_lattice(t, x, tuning, [&](const Vec3& p) {
    const double bound = std::abs(corner) + (p - x[t[0]]).norm() + tuning.far;
    least = std::min(least, skin.signed_distance(p, nullptr, bound));
    return true;
  });
  return least;
}

/// Whether no point of the lattice is about to cut, of a triangle that does not cut and has its
/// corners outside. Then all of it is outside, as far as the skin does not cut itself, and a look
/// round each point will do.
bool is_clear(const geometry::ClosestPointTree& skin, const Triangle& t, const std::vector<Vec3>& x,
              const PenetrationTuning& tuning) {
  return visit_lattice(t, x, tuning, [&](const Vec3& p) {
    return skin.query(p, tuning.near_penetration).triangle < 0;
  });
}

/// The least distance of every triangle, in parallel; `far` where it is clear or its corners
/// are plainly farther, unless something thin (a thumb) is known to go through it.
std::vector<double> least_distances(const geometry::ClosestPointTree& skin,
                                    const std::vector<Triangle>& triangles,
                                    const std::vector<Vec3>& x, const std::set<int>& cut,
                                    const PenetrationTuning& tuning) {
  std::vector<double> corner(x.size());
  tbb::parallel_for(std::size_t{0}, x.size(), [&](std::size_t i) {
    corner[i] = skin.signed_distance(x[i], nullptr, tuning.signed_reach);
  });
  std::vector<double> least(triangles.size(), tuning.far);
  tbb::parallel_for(std::size_t{0}, triangles.size(), [&](std::size_t i) {
    const Triangle& t = triangles[i];
    const double lowest = std::min({corner[t[0]], corner[t[1]], corner[t[2]]});
    const bool cuts = cut.count(static_cast<int>(i)) > 0;
    if (!cuts && (lowest >= tuning.far || (lowest > 0 && is_clear(skin, t, x, tuning)))) return;
    least[i] = least_distance(skin, t, x, corner[t[0]], tuning);
  });
  return least;
}

/// Triangles that have their lattice of contact points already: from an earlier round, or from the
/// posture before.
std::set<Triangle> with_lattice(const std::vector<contact::ContactPoint>& points) {
  std::set<Triangle> triangles;
  for (const contact::ContactPoint& p : points)
    if (p.count == 3) triangles.insert(p.particle);
  return triangles;
}

}  // namespace

std::set<int> penetrating_triangles(const ClothMesh& cloth, const body::PosedBody& body,
                                    const std::vector<Vec3>& x) {
  std::set<int> cut;
  for (const auto& [t, s] : geometry::mesh_intersections(x, cloth.triangles, body.tree()))
    cut.insert(t);
  return cut;
}

bool raise_offsets_at_penetrations(ClothModel& model, const ContactBody& body,
                                   const std::vector<Vec3>& x,
                                   const std::vector<double>& half_thickness,
                                   const std::set<int>& penetrating, std::map<int, int>& times_cut,
                                   const PenetrationTuning& tuning) {
  const ClothMesh& cloth = model.mesh();
  const auto& triangles = cloth.triangles;
  std::set<int> cut = penetrating;
  // Those that are about to cut are treated alike, or each round would find their neighbours.
  const geometry::ClosestPointTree& skin = body.body.tree();
  const std::vector<double> least = least_distances(skin, triangles, x, cut, tuning);
  for (std::size_t t = 0; t < triangles.size(); ++t)
    if (least[t] < tuning.near_penetration) cut.insert(static_cast<int>(t));
  // Each of them gets its lattice, and a raise by what it lacks of its clearance.
  std::vector<std::set<Triangle>> latticed;
  for (int layer = 0; layer < cloth.layers(); ++layer)
    latticed.push_back(with_lattice(model.body(layer).points()));
  std::map<int, std::vector<int>> cuts_at;  // vertex → cut triangles
  std::map<int, double> raise;              // of a triangle's contact points [m]
  for (int t : cut) {
    const int layer = cloth.triangle_layer[t];
    ++times_cut[t];
    if (latticed[layer].insert(triangles[t]).second)
      contact::add_lattice(triangles[t], cloth.area[t], half_thickness[layer],
                           lattice_intervals(triangles[t], x, tuning),
                           model.body(layer).change_points());
    for (int v : triangles[t]) cuts_at[v].push_back(t);
    raise[t] = std::clamp(tuning.clearance - least[t], 0.0, tuning.largest_raise) +
               tuning.clearance_each_time * times_cut[t];
  }
  // All contact points on them are raised, also by what the field errs there.
  const double farthest = body.field->smooth_reach();
  bool raised = false;
  for (int layer = 0; layer < cloth.layers(); ++layer) {
    contact::BodyContact& contact = model.body(layer);
    for (contact::ContactPoint& p : contact.change_points()) {
      const auto near = cuts_at.find(p.particle[0]);
      if (near == cuts_at.end()) continue;
      double most = -1;
      for (int t : near->second)
        if (p.within(triangles[t])) most = std::max(most, raise.at(t));
      if (most < 0) continue;
      const double seen = contact.field_distance(p, x, tuning.far);
      const double error = seen < tuning.far ? seen - skin.signed_distance(p.position(x)) : 0;
      const double needed =
          half_thickness[layer] + std::clamp(error, 0.0, tuning.largest_field_error);
      const double offset = std::min(farthest, std::max(p.offset, needed) + most);
      raised = raised || offset > p.offset;
      p.offset = std::max(p.offset, offset);
    }
  }
  return raised;
}

}  // namespace loosefit::drape

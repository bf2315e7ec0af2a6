#include "loosefit/drape/hold_off_cuts.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "loosefit/geometry/closest_point_tree.h"
#include "loosefit/geometry/exact_intersection.h"

namespace loosefit {
namespace {

constexpr int kLeastLattice = 4;      ///< intervals along an edge of a cut triangle
constexpr double kLattice = 0.0035;   ///< largest of them [m]
constexpr double kClear = 1.2e-4;     ///< clearance asked of a triangle that cut [m]
constexpr double kEachTime = 3e-5;    ///< more for each time that it cut [m]
constexpr double kAboutToCut = 8e-5;  ///< clearance below which a triangle counts as cut [m]
constexpr double kFarField = 0.002;   ///< largest correction at one time [m]
constexpr double kFarthest = 0.05;    ///< from the skin, inside or out, that is told apart [m]

int lattice(const Triangle& t, const std::vector<Vec3>& x) {
  double longest = 0;
  for (int k = 0; k < 3; ++k) longest = std::max(longest, (x[t[k]] - x[t[(k + 1) % 3]]).norm());
  return std::max(kLeastLattice, static_cast<int>(std::ceil(longest / kLattice)));
}

/// visit(p) for the points of a lattice over the triangle until that says false; true if it never
/// did.
template <class Visit>
bool visit_lattice(const Triangle& t, const std::vector<Vec3>& x, const Visit& visit) {
  const int n = lattice(t, x);
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
double least_distance(const ClosestPointTree& skin, const Triangle& t, const std::vector<Vec3>& x,
                      double corner) {
  double least = kFarField;
  visit_lattice(t, x, [&](const Vec3& p) {
    const double bound = std::abs(corner) + (p - x[t[0]]).norm() + kFarField;
    least = std::min(least, skin.signed_distance(p, nullptr, bound));
    return true;
  });
  return least;
}

/// Whether no point of the lattice is about to cut, of a triangle that does not cut and has its
/// corners outside. Then all of it is outside, as far as the skin does not cut itself, and a look
/// round each point will do.
bool is_clear(const ClosestPointTree& skin, const Triangle& t, const std::vector<Vec3>& x) {
  return visit_lattice(t, x,
                       [&](const Vec3& p) { return skin.query(p, kAboutToCut).triangle < 0; });
}

/// The least distance of every triangle, in parallel; kFarField where it is clear or its corners
/// are plainly farther, unless something thin (a thumb) is known to go through it.
std::vector<double> least_distances(const ClosestPointTree& skin,
                                    const std::vector<Triangle>& triangles,
                                    const std::vector<Vec3>& x, const std::set<int>& cut) {
  std::vector<double> corner(x.size());
  tbb::parallel_for(std::size_t{0}, x.size(), [&](std::size_t i) {
    corner[i] = skin.signed_distance(x[i], nullptr, kFarthest);
  });
  std::vector<double> least(triangles.size(), kFarField);
  tbb::parallel_for(std::size_t{0}, triangles.size(), [&](std::size_t i) {
    const Triangle& t = triangles[i];
    const double lowest = std::min({corner[t[0]], corner[t[1]], corner[t[2]]});
    const bool cuts = cut.count(static_cast<int>(i)) > 0;
    if (!cuts && (lowest >= kFarField || (lowest > 0 && is_clear(skin, t, x)))) return;
    least[i] = least_distance(skin, t, x, corner[t[0]]);
  });
  return least;
}

/// Triangles that have their lattice of contact points already: from an earlier round, or from the
/// posture before.
std::set<Triangle> with_lattice(const std::vector<ContactPoint>& points) {
  std::set<Triangle> triangles;
  for (const ContactPoint& p : points)
    if (p.count == 3) triangles.insert(p.particle);
  return triangles;
}

}  // namespace

CutRound hold_off_cuts(ClothModel& model, const ContactBody& body, const std::vector<Vec3>& x,
                       const std::vector<double>& half_thickness, bool look_ahead,
                       std::map<int, int>& times_cut) {
  const ClothMesh& cloth = model.mesh();
  const auto& triangles = cloth.triangles;
  const ClosestPointTree& skin = body.body.tree();
  std::set<int> cut;
  for (const auto& [t, s] : mesh_intersections(x, triangles, skin)) cut.insert(t);
  const bool any = !cut.empty();
  if (!any && !look_ahead) return {};
  // Those that are about to cut are treated alike, or each round would find their neighbours.
  const std::vector<double> least = least_distances(skin, triangles, x, cut);
  for (std::size_t t = 0; t < triangles.size(); ++t)
    if (least[t] < kAboutToCut) cut.insert(static_cast<int>(t));
  std::vector<std::set<Triangle>> latticed;
  for (int layer = 0; layer < cloth.layers(); ++layer)
    latticed.push_back(with_lattice(model.body(layer).points()));
  std::map<int, std::vector<int>> cuts_at;  // vertex → cut triangles
  std::map<int, double> raise;              // of a triangle's contact points [m]
  for (int t : cut) {
    const int layer = cloth.triangle_layer[t];
    ++times_cut[t];
    if (latticed[layer].insert(triangles[t]).second)
      add_lattice(triangles[t], cloth.area[t], half_thickness[layer], lattice(triangles[t], x),
                  model.body(layer).change_points());
    for (int v : triangles[t]) cuts_at[v].push_back(t);
    raise[t] = std::clamp(kClear - least[t], 0.0, kFarField) + kEachTime * times_cut[t];
  }
  const double farthest = body.field->smooth_reach();
  bool held = false;
  for (int layer = 0; layer < cloth.layers(); ++layer) {
    BodyContact& contact = model.body(layer);
    for (ContactPoint& p : contact.change_points()) {
      const auto near = cuts_at.find(p.particle[0]);
      if (near == cuts_at.end()) continue;
      double most = -1;
      for (int t : near->second)
        if (p.within(triangles[t])) most = std::max(most, raise.at(t));
      if (most < 0) continue;
      const double seen = contact.field_distance(p, x, kFarField);
      const double error = seen < kFarField ? seen - skin.signed_distance(p.position(x)) : 0;
      const double needed = half_thickness[layer] + std::clamp(error, 0.0, kFarField);
      const double offset = std::min(farthest, std::max(p.offset, needed) + most);
      held = held || offset > p.offset;
      p.offset = std::max(p.offset, offset);
    }
  }
  return {any, held};
}

}  // namespace loosefit

#include "loosefit/dress/dress_as_placed.h"

#include <fmt/format.h>

#include <cmath>
#include <set>

#include "loosefit/base/error.h"
#include "loosefit/geometry/closest_point_tree.h"
#include "loosefit/geometry/exact_intersection.h"

namespace loosefit::dress {
namespace {

constexpr double kStep = 0.01;     ///< by which a panel in trouble is moved at a time [m]
constexpr double kAlike = 0.5;     ///< cosine between the normals of panels that look the same way
constexpr double kFarthest = 0.3;  ///< it is moved at most [m]

/// Positions with panel k moved by `out[k]` along its outside normal; seams at the mean.
std::vector<Vec3> place(const garment::Garment& garment, const pattern::Pattern& pattern,
                        const std::vector<double>& out) {
  std::vector<Vec3> sum(garment.vertex_count, Vec3::Zero());
  std::vector<int> count(garment.vertex_count, 0);
  std::set<std::pair<int, int>> seen;  // (vertex, panel)
  for (std::size_t t = 0; t < garment.triangles.size(); ++t) {
    const int k = garment.triangle_panel[t];
    const pattern::Panel& panel = pattern.panels[pattern.find_panel(garment.panel_names[k])];
    for (int c = 0; c < 3; ++c) {
      const int v = garment.triangles[t][c];
      if (!seen.emplace(v, k).second) continue;
      const Vec2& uv = garment.triangle_uv[t][c];
      sum[v] += panel.rotation * Vec3(uv[0], uv[1], out[k]) + panel.translation;
      ++count[v];
    }
  }
  for (int v = 0; v < garment.vertex_count; ++v) sum[v] /= std::max(1, count[v]);
  return sum;
}

Vec3 outside(const garment::Garment& garment, const pattern::Pattern& pattern, int panel) {
  return pattern.panels[pattern.find_panel(garment.panel_names[panel])].rotation.col(2);
}

/// Panels that cut another one, or of which a vertex off the seams lies in the body.
std::set<int> in_trouble(const garment::Garment& garment, const pattern::Pattern& pattern,
                         const std::vector<std::set<int>>& panels_of, const std::vector<Vec3>& x,
                         const geometry::ClosestPointTree& skin,
                         const std::vector<std::pair<int, int>>& hits) {
  std::set<int> found;
  for (const auto& [s, t] : hits) {
    const auto [a, b] = std::minmax(garment.triangle_panel[s], garment.triangle_panel[t]);
    found.insert(b);
    if (outside(garment, pattern, a).dot(outside(garment, pattern, b)) < kAlike) found.insert(a);
  }
  for (std::size_t v = 0; v < x.size(); ++v)
    if (panels_of[v].size() == 1 && !found.count(*panels_of[v].begin()) &&
        skin.signed_distance(x[v]) < 0)
      found.insert(*panels_of[v].begin());
  return found;
}

}  // namespace

std::vector<Vec3> dress_as_placed(const garment::Garment& garment, const pattern::Pattern& pattern,
                                  const body::PosedBody& body) {
  std::vector<std::set<int>> panels_of(garment.vertex_count);
  for (std::size_t t = 0; t < garment.triangles.size(); ++t) {
    const int k = garment.triangle_panel[t];
    if (pattern.find_panel(garment.panel_names[k]) < 0)
      throw GeometryError("pattern: panel " + garment.panel_names[k] + " is missing");
    for (int v : garment.triangles[t]) panels_of[v].insert(k);
  }
  const geometry::ClosestPointTree& skin = body.tree();
  std::vector<double> out(garment.panel_names.size(), 0.0);
  std::vector<Vec3> x = place(garment, pattern, out);
  auto hits = geometry::self_intersections(x, garment.triangles);
  const auto first_hits = hits;
  for (int k = 0; k < std::lround(kFarthest / kStep); ++k) {
    const std::set<int> moving = in_trouble(garment, pattern, panels_of, x, skin, hits);
    if (moving.empty()) return x;
    for (int panel : moving) out[panel] += kStep;
    x = place(garment, pattern, out);
    hits = geometry::self_intersections(x, garment.triangles);
  }
  if (hits.empty()) return x;  // what still lies in the body is pushed out by contact
  const auto [a, b] = first_hits.empty() ? hits.front() : first_hits.front();
  throw GeometryError(
      fmt::format("pattern: the placed panels cut through each other, {} triangle pairs, first "
                  "between {} and {}, and moving them outwards by {} m does not part them",
                  hits.size(), garment.panel_names[garment.triangle_panel[a]],
                  garment.panel_names[garment.triangle_panel[b]], kFarthest),
      "move the panels apart (translation, rotation) so that sewn edges face each other");
}

}  // namespace loosefit::dress

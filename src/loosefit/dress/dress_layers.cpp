#include "loosefit/dress/dress_layers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <queue>

#include "loosefit/base/error.h"
#include "loosefit/body/surface_distance.h"
#include "loosefit/dress/garments_cut.h"
#include "loosefit/dress/no_room.h"
#include "loosefit/geometry/exact_intersection.h"

namespace loosefit::dress {
namespace {

/// Tries for the innermost garment [m]: between trunk and arm there is room for a few centimetres
/// in all, too little for wide steps and, for coarse triangles, for narrow ones.
constexpr double kInnermost[] = {0.012, 0.010, 0.014, 0.008, 0.020};
constexpr double kMostClearance = 0.08;
constexpr double kStep = 1.1, kFirstStep = 1.35;  ///< of the clearance, and beyond the layer below
constexpr double kLeastDepth = 0.008;             ///< more for every layer [m]
constexpr double kDepthShares[] = {1.0, 1.5};
/// Tries for a garment that is placed over others: how much farther from the skin than they are
/// [m], where they are as far from it.
constexpr double kFarther[] = {0.002, 0.005, 0.01, 0.007, 0.014, 0.02, 0.03};
constexpr double kSlope = 0.3;  ///< of padding towards skin that nothing covers

/// Everything that is on already.
struct Dressed {
  std::vector<Vec3> positions;
  std::vector<Triangle> triangles;
  double clearance = 0;

  void add(const garment::Garment& garment, const std::vector<Vec3>& x) {
    const int shift = static_cast<int>(positions.size());
    positions.insert(positions.end(), x.begin(), x.end());
    for (const Triangle& t : garment.triangles)
      triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
  }
};

/// Nearest to the body where nothing cuts; what was wrong with the last try in `why`.
std::optional<std::vector<Vec3>> lay_over(const LayerToDress& to_dress, const body::Body& body,
                                          int layer, Dressed& under, std::string& why) {
  const garment::Garment& garment = *to_dress.garment;
  const double most = layer == 0 ? kStep * under.clearance : kMostClearance;
  for (double c = under.clearance; c < most; c *= kStep)
    for (const double share : kDepthShares) try {
        const auto x = to_dress.lay(garment, body, {c, (1 + layer) * kLeastDepth, share, true});
        const auto own = geometry::self_intersections(x, garment.triangles);
        const auto cuts =
            geometry::mesh_intersections(x, garment.triangles, under.positions, under.triangles);
        if (own.empty() && cuts.empty()) {
          under.clearance = kFirstStep * c;
          return x;
        }
        why = fmt::format(
            "{} pairs of its triangles cut each other at the start, {} what is under it",
            own.size(), cuts.size());
      } catch (const NoRoom& error) {
        why = error.what();
      }
  return {};
}

/// How far what is on stands off each vertex of the skin [m], on to the skin beside it, where it
/// falls by kSlope: the skin moved outwards by so much encloses it, but for its folds.
std::vector<double> stand_off(const body::PosedBody& body, const std::vector<Vec3>& cloth) {
  const geometry::TriangleMesh& skin = body->surface;
  std::vector<double> off(skin.vertices.size(), 0);
  for (const Vec3& p : cloth) {
    const auto nearest = body.tree().query(p);
    for (const int v : skin.triangles[nearest.triangle])
      off[v] = std::max(off[v], (p - nearest.point).norm());
  }
  // The largest first, as in Dijkstra's method: what has come off the queue grows no more.
  const auto neighbours = body::neighbours_of(skin);
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry> queue;
  for (std::size_t v = 0; v < off.size(); ++v)
    if (off[v] > 0) queue.push({off[v], static_cast<int>(v)});
  while (!queue.empty()) {
    const auto [from, v] = queue.top();
    queue.pop();
    if (from < off[v]) continue;
    for (const int other : neighbours[v]) {
      const double here = from - kSlope * (skin.vertices[v] - skin.vertices[other]).norm();
      if (here > off[other]) queue.push({off[other] = here, other});
    }
  }
  return off;
}

/// The same person thicker by what is on, and by so much more there [m], as if it wore padding:
/// hands that grew too would leave no room in the cuffs. Folds of its skin may pass through each
/// other.
body::PosedBody padded(const body::Body& body, const std::vector<double>& off, double by) {
  body::Body more = body;
  const auto normals = geometry::vertex_normals(body.surface.vertices, body.surface.triangles);
  for (std::size_t v = 0; v < normals.size(); ++v)
    more.surface.vertices[v] += (off[v] + std::min(by, off[v])) * normals[v];
  return more;
}

/// As if the wearer were thicker by the least that encloses what is under it.
std::vector<Vec3> place_over(const LayerToDress& layer, const Dressed& under,
                             const body::PosedBody& body) {
  const garment::Garment& garment = *layer.garment;
  const std::vector<double> off = stand_off(body, under.positions);
  std::string why;
  double last = 0;
  std::optional<std::vector<Vec3>> cutting_skin;
  const double farthest = off.empty() ? 0 : *std::ranges::max_element(off);
  for (const double by : kFarther) try {
      if (by != kFarther[0] && farthest <= last) break;  // the same again
      last = by;
      std::vector<Vec3> x = layer.place(under.positions.empty() ? body : padded(body, off, by));
      const auto cuts =
          geometry::mesh_intersections(x, garment.triangles, under.positions, under.triangles);
      if (cuts.empty()) {
        if (under.positions.empty() ||
            geometry::mesh_intersections(x, garment.triangles, body.tree()).empty())
          return x;
        // Where padding ends, cloth may cut the skin: settling frees it if nothing better comes.
        if (!cutting_skin) cutting_skin = std::move(x);
        continue;
      }
      why = fmt::format("{} triangle pairs, the first in panel {}", cuts.size(),
                        garment.panel_names[garment.triangle_panel[cuts.front().first]]);
      if (under.positions.empty()) break;
    } catch (const NoRoom&) {
      if (by == kFarther[0]) throw;
    }
  if (cutting_skin) return *std::move(cutting_skin);
  throw GarmentsCut(
      "pattern: the placed panels cut through the garments under them, " + why,
      "more room in the outer garment, or a closer one under it; panels of a file that gives them "
      "places may be placed farther out (translation)");
}

}  // namespace

std::vector<Vec3> dress_layers(const std::vector<LayerToDress>& layers,
                               const body::PosedBody& body) {
  if (layers.size() == 1 && layers[0].lay)
    return lay_round(*layers[0].garment, body, layers[0].lay);
  std::string why;
  for (const double innermost : kInnermost) {
    Dressed dressed{.positions = {}, .triangles = {}, .clearance = innermost};
    bool done = true;
    for (int l = 0; done && l < static_cast<int>(layers.size()); ++l) {
      const LayerToDress& layer = layers[l];
      const auto x =
          layer.lay ? lay_over(layer, body, l, dressed, why) : place_over(layer, dressed, body);
      if ((done = x.has_value())) dressed.add(*layer.garment, *x);
    }
    if (done) return dressed.positions;
  }
  throw NoRoom("the garments cannot be laid round this body over each other: " + why);
}

}  // namespace loosefit::dress

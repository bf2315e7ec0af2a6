#include "loosefit/dress/dress_layers.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "loosefit/base/error.h"
#include "loosefit/body/surface_distance.h"
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
/// Tries for a garment that is placed over others: how much farther from the skin [m].
constexpr double kThicker[] = {0, 0.02, 0.03, 0.045, 0.06, 0.08, 0.11};
/// Skin so far from the nearest vertices of cloth is covered, and beyond the other not padded [m].
constexpr double kCovered = 0.03, kBeside = 0.10;

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

/// How far each vertex of the skin is over the surface from what is under the cloth's vertices [m].
std::vector<double> from_cloth(const body::PosedBody& body, const std::vector<Vec3>& cloth) {
  std::vector<int> covered;
  for (const Vec3& p : cloth)
    for (const int v : body->surface.triangles[body.tree().query(p).triangle]) covered.push_back(v);
  return body::surface_distance(body->surface, covered);
}

/// The same person with so much more round what is covered [m], as if it wore padding: hands that
/// grew too would leave no room in the cuffs. Folds of its skin may pass through each other.
body::PosedBody thicker(const body::Body& body, const std::vector<double>& from_cloth, double by) {
  body::Body more = body;
  const auto normals = geometry::vertex_normals(body.surface.vertices, body.surface.triangles);
  for (std::size_t v = 0; v < normals.size(); ++v) {
    const double share = (kBeside - from_cloth[v]) / (kBeside - kCovered);
    more.surface.vertices[v] += by * std::clamp(share, 0.0, 1.0) * normals[v];
  }
  return more;
}

/// As if the wearer were thicker by the least that encloses what is under it.
std::vector<Vec3> place_over(const LayerToDress& layer, const Dressed& under,
                             const body::PosedBody& body) {
  const garment::Garment& garment = *layer.garment;
  const std::vector<double> apart = from_cloth(body, under.positions);
  std::string why;
  for (const double by : kThicker) try {
      std::vector<Vec3> x = layer.place(by > 0 ? thicker(body, apart, by) : body);
      const auto cuts =
          geometry::mesh_intersections(x, garment.triangles, under.positions, under.triangles);
      if (cuts.empty()) return x;
      why = fmt::format("{} triangle pairs, the first in panel {}", cuts.size(),
                        garment.panel_names[garment.triangle_panel[cuts.front().first]]);
      if (under.positions.empty()) break;
    } catch (const NoRoom&) {
      if (by == 0) throw;
    }
  throw GeometryError(
      "pattern: the placed panels cut through the garments under them, " + why,
      "place the panels farther out (translation), so that they enclose what is under them");
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

#include "loosefit/base/error.h"
#include "loosefit/dress/dress.h"
#include "loosefit/dress/lay_shirt.h"
#include "loosefit/geometry/exact_intersection.h"

namespace loosefit {
namespace {

constexpr double kClearance = 0.02;  ///< of the innermost layer [m]
constexpr double kMore = 1.5;        ///< first clearance of a layer over that of the one under it

}  // namespace

std::vector<Vec3> dress_layers(const std::vector<LayerToDress>& layers, const Body& body) {
  TriangleMesh under;  // all layers so far
  double clearance = kClearance;
  for (int l = 0; l < static_cast<int>(layers.size()); ++l) {
    const Garment& garment = *layers[l].garment;
    std::vector<Vec3> x;
    if (is_shirt(garment)) {
      ShirtStart start = lay_shirt(garment, body, clearance, l, under);
      x = std::move(start.positions);
      clearance = kMore * start.clearance;
    } else {
      x = dress_as_placed(garment, *layers[l].pattern);
      const auto cuts = mesh_intersections(x, garment.triangles, under.vertices, under.triangles);
      if (!cuts.empty())
        throw GeometryError(
            "pattern: the placed panels cut through the garment under it, " +
                std::to_string(cuts.size()) + " triangle pairs, the first in panel " +
                garment.panel_names[garment.triangle_panel[cuts.front().first]],
            "place the panels farther out (translation), so that they enclose what is under them");
    }
    const int shift = static_cast<int>(under.vertices.size());
    under.vertices.insert(under.vertices.end(), x.begin(), x.end());
    for (const Triangle& t : garment.triangles)
      under.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
  }
  return under.vertices;
}

}  // namespace loosefit

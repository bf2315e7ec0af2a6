#include "loosefit/placement/sites.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "loosefit/base/error.h"
#include "loosefit/base/text.h"
#include "loosefit/placement/footprint.h"

namespace loosefit {
namespace {

/// A point of the garment by triangle.
struct GarmentPoint {
  int triangle = -1;
  Vec3 barycentric = Vec3::Zero();
};

Vec3 lifted(const Vec2& p) { return {p.x(), p.y(), 0}; }

GarmentPoint in_pattern(const Garment& garment, const SiteSpec& spec) {
  const auto panel = std::find(garment.panel_names.begin(), garment.panel_names.end(), spec.panel);
  if (panel == garment.panel_names.end())
    throw InvalidInput(
        "site " + printable(spec.name) + ": unknown panel '" + printable(spec.panel) + "'",
        did_you_mean(spec.panel, garment.panel_names));
  const int index = static_cast<int>(panel - garment.panel_names.begin());
  constexpr double kEdgeSlack = 1e-4;  // a mesh cuts the corners of a curved outline [m]
  GarmentPoint best;
  Vec3 nearest = Vec3::Zero();
  double distance = std::numeric_limits<double>::infinity();
  for (int t = 0; t < static_cast<int>(garment.triangles.size()); ++t) {
    if (garment.triangle_panel[t] != index) continue;
    const auto& uv = garment.triangle_uv[t];
    const Vec3 a = lifted(uv[0]), b = lifted(uv[1]), c = lifted(uv[2]);
    const Vec3 weights = closest_barycentric(lifted(spec.at), a, b, c);
    const Vec3 point = weights[0] * a + weights[1] * b + weights[2] * c;
    if (const double d = (point - lifted(spec.at)).norm(); d < distance) {
      distance = d;
      nearest = point;
      best = {t, weights};
    }
  }
  if (!(distance <= kEdgeSlack))
    throw InvalidInput("site " + printable(spec.name) + ": (" + shortest(spec.at.x()) + ", " +
                           shortest(spec.at.y()) + ") m lies outside panel " + spec.panel,
                       "the nearest place in it is (" +
                           shortest(std::round(nearest.x() * 1e4) / 1e4) + ", " +
                           shortest(std::round(nearest.y() * 1e4) / 1e4) + ") m");
  return best;
}

/// Nearest garment point that faces as the body does there.
std::optional<GarmentPoint> over_body(const ClosestPointTree& garment_tree,
                                      const ClosestPointTree& body_tree, const Body& body,
                                      const Vec3& point) {
  const ClosestPoint on_body = body_tree.query(point);
  const Triangle& corner = body.surface.triangles[on_body.triangle];
  Vec3 normal = Vec3::Zero();
  for (int k = 0; k < 3; ++k) normal += on_body.barycentric[k] * body.normals[corner[k]];
  const TriangleMesh& cloth = garment_tree.mesh();
  const ClosestPoint hit = garment_tree.query(point, kCoverReach, [&](int t) {
    const Triangle& c = cloth.triangles[t];
    return triangle_normal(cloth.vertices[c[0]], cloth.vertices[c[1]], cloth.vertices[c[2]])
               .dot(normal) > 0;
  });
  if (hit.triangle < 0) return std::nullopt;
  return GarmentPoint{hit.triangle, hit.barycentric};
}

Site describe(const std::string& name, const GarmentPoint& point, const Garment& garment,
              const std::vector<Vec3>& positions, const WornGarment& worn,
              const std::vector<PerformanceMap>& maps, double radius) {
  Site site;
  site.name = name;
  site.panel = garment.panel_names[garment.triangle_panel[point.triangle]];
  const Triangle& corner = garment.triangles[point.triangle];
  for (int k = 0; k < 3; ++k) {
    site.at += point.barycentric[k] * garment.triangle_uv[point.triangle][k];
    site.position += point.barycentric[k] * positions[corner[k]];
  }
  int nearest = 0;
  point.barycentric.maxCoeff(&nearest);
  site.body_point = worn.partners[corner[nearest]].exact.point;
  site.region = worn.regions[corner[nearest]];
  const Footprint patch = footprint(garment, positions, point.triangle, point.barycentric, radius);
  for (const PerformanceMap& map : maps)
    site.values[map.array] = average(patch, garment, map.values);
  return site;
}

}  // namespace

void check_sites(const Garment& garment, const Body& body, const std::vector<SiteSpec>& wished) {
  for (std::size_t i = 0; i < wished.size(); ++i) {
    const SiteSpec& spec = wished[i];
    const bool known_panel = std::find(garment.panel_names.begin(), garment.panel_names.end(),
                                       spec.panel) != garment.panel_names.end();
    const char* key = spec.panel.empty() ? "landmark" : known_panel ? "at" : "panel";
    try {
      spec.panel.empty() ? void(site_point(body, spec.landmark)) : void(in_pattern(garment, spec));
    } catch (const InvalidInput& error) {
      throw error.at({"", 0, "site[" + std::to_string(i) + "]." + key});
    }
  }
}

std::vector<Site> find_sites(const Garment& garment, const std::vector<Vec3>& positions,
                             const Body& body, const WornGarment& worn,
                             const std::vector<PerformanceMap>& maps,
                             const std::vector<SiteSpec>& wished, bool with_presets,
                             double radius) {
  const TriangleMesh cloth{positions, garment.triangles};
  const ClosestPointTree garment_tree(cloth), body_tree(body.surface);
  std::vector<Site> sites;
  const auto add = [&](const SiteSpec& spec, bool must_be_covered) {
    std::optional<GarmentPoint> point;
    if (spec.panel.empty()) {
      point = over_body(garment_tree, body_tree, body, site_point(body, spec.landmark));
    } else {
      point = in_pattern(garment, spec);
    }
    if (point)
      sites.push_back(describe(spec.name, *point, garment, positions, worn, maps, radius));
    else if (must_be_covered)
      throw InvalidInput("site " + printable(spec.name) + ": the garment does not cover " +
                         spec.landmark);
  };
  for (const SiteSpec& spec : wished) add(spec, true);
  if (with_presets)
    for (const SiteSpec& spec : preset_sites(body)) add(spec, false);
  return sites;
}

}  // namespace loosefit

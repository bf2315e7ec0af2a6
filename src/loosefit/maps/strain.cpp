#include "loosefit/maps/strain.h"

#include <Eigen/Dense>
#include <cmath>
#include <limits>
#include <map>

namespace loosefit {
namespace {
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
}  // namespace

DeformationGradient garment_gradient(const Garment& garment, int triangle,
                                     const std::vector<Vec3>& positions) {
  return deformation_gradient(garment.triangle_uv[triangle], garment.triangles[triangle],
                              positions);
}

double strain_along(const DeformationGradient& f, const Vec2& direction) {
  return (f * direction).norm() - 1;
}

TriangleStrain triangle_strain(const Garment& garment, int triangle,
                               const std::vector<Vec3>& positions) {
  return triangle_strain(garment_gradient(garment, triangle, positions));
}

double slack_of(const TriangleStrain& strain) {
  return std::isnan(strain.min) ? kNan : strain.min < kSlackStrain ? 1.0 : 0.0;
}

TriangleStrain triangle_strain(const DeformationGradient& f) {
  const double uu = f.col(0).squaredNorm(), vv = f.col(1).squaredNorm();
  const double uv_product = f.col(0).dot(f.col(1));
  // Eigenvalues of FᵀF. std::max passes NaN of its first argument on.
  const double mean = 0.5 * (uu + vv), spread = std::hypot(0.5 * (uu - vv), uv_product);
  return {std::sqrt(uu) - 1, std::sqrt(vv) - 1, std::sqrt(mean + spread) - 1,
          std::sqrt(std::max(mean - spread, 0.0)) - 1};
}

std::vector<TriangleStrain> triangle_strains(const Garment& garment,
                                             const std::vector<Vec3>& positions) {
  std::vector<TriangleStrain> strains;
  strains.reserve(garment.triangles.size());
  for (int t = 0; t < static_cast<int>(garment.triangles.size()); ++t)
    strains.push_back(triangle_strain(garment, t, positions));
  return strains;
}

std::vector<double> to_vertices(const Garment& garment, const std::vector<double>& per_triangle) {
  std::vector<double> sum(garment.vertex_count, 0.0), weight(garment.vertex_count, 0.0);
  for (std::size_t t = 0; t < garment.triangles.size(); ++t) {
    if (std::isnan(per_triangle[t])) continue;
    const double area = flat_area(garment.triangle_uv[t]);
    for (int v : garment.triangles[t]) {
      sum[v] += area * per_triangle[t];
      weight[v] += area;
    }
  }
  for (int v = 0; v < garment.vertex_count; ++v) sum[v] = weight[v] > 0 ? sum[v] / weight[v] : kNan;
  return sum;
}

std::vector<double> vertical_strain(const Garment& garment, const std::vector<Vec3>& positions) {
  struct Edge {
    Vec2 flat;
    bool seam = false;
  };
  constexpr double kSameEdge = 1e-9;  // [m]
  std::map<std::pair<int, int>, Edge> edges;
  std::map<std::pair<int, int>, int> panel_of;
  for (std::size_t t = 0; t < garment.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      const int a = garment.triangles[t][k], b = garment.triangles[t][(k + 1) % 3];
      const Vec2 along = garment.triangle_uv[t][(k + 1) % 3] - garment.triangle_uv[t][k];
      const Vec2 flat = a < b ? along : Vec2(-along);
      const auto key = std::minmax(a, b);
      const auto [place, is_new] = edges.try_emplace(key, Edge{flat});
      const int panel = garment.triangle_panel[t];
      const int first_panel = panel_of.try_emplace(key, panel).first->second;
      if (!is_new && (panel != first_panel || (flat - place->second.flat).norm() > kSameEdge))
        place->second.seam = true;
    }
  std::vector<double> sum(garment.vertex_count, 0.0), weight(garment.vertex_count, 0.0);
  for (const auto& [key, edge] : edges) {
    const double rest = edge.flat.norm();
    if (edge.seam || rest <= 0) continue;
    const double cosine = edge.flat.y() / rest, w = cosine * cosine;
    const double strain = (positions[key.second] - positions[key.first]).norm() / rest - 1;
    for (int v : {key.first, key.second}) {
      sum[v] += w * strain;
      weight[v] += w;
    }
  }
  constexpr double kEnough = 1e-6;  // only edges across the grain: no vertical strain to speak of
  for (int v = 0; v < garment.vertex_count; ++v)
    sum[v] = weight[v] > kEnough ? sum[v] / weight[v] : kNan;
  return sum;
}

std::vector<double> vertex_areas(const Garment& garment) {
  std::vector<double> areas(garment.vertex_count, 0.0);
  for (std::size_t t = 0; t < garment.triangles.size(); ++t)
    for (int v : garment.triangles[t]) areas[v] += flat_area(garment.triangle_uv[t]) / 3;
  return areas;
}

}  // namespace loosefit

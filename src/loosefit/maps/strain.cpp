#include "loosefit/maps/strain.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

#include "loosefit/geometry/mesh_topology.h"

namespace loosefit::maps {
namespace {
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
}  // namespace

geometry::DeformationGradient garment_gradient(const garment::Garment& garment, int triangle,
                                               const std::vector<Vec3>& positions) {
  return geometry::deformation_gradient(garment.triangle_uv[triangle], garment.triangles[triangle],
                                        positions);
}

double strain_along(const geometry::DeformationGradient& f, const Vec2& direction) {
  return (f * direction).norm() - 1;
}

TriangleStrain triangle_strain(const garment::Garment& garment, int triangle,
                               const std::vector<Vec3>& positions) {
  return triangle_strain(garment_gradient(garment, triangle, positions));
}

double slack_of(const TriangleStrain& strain) {
  return std::isnan(strain.min) ? kNan : strain.min < kSlackStrain ? 1.0 : 0.0;
}

TriangleStrain triangle_strain(const geometry::DeformationGradient& f) {
  const double uu = f.col(0).squaredNorm(), vv = f.col(1).squaredNorm();
  const double uv_product = f.col(0).dot(f.col(1));
  // Eigenvalues of FᵀF. std::max passes NaN of its first argument on.
  const double mean = 0.5 * (uu + vv), spread = std::hypot(0.5 * (uu - vv), uv_product);
  return {std::sqrt(uu) - 1, std::sqrt(vv) - 1, std::sqrt(mean + spread) - 1,
          std::sqrt(std::max(mean - spread, 0.0)) - 1};
}

std::vector<TriangleStrain> triangle_strains(const garment::Garment& garment,
                                             const std::vector<Vec3>& positions) {
  std::vector<TriangleStrain> strains;
  strains.reserve(garment.triangles.size());
  for (int t = 0; t < static_cast<int>(garment.triangles.size()); ++t)
    strains.push_back(triangle_strain(garment, t, positions));
  return strains;
}

std::vector<double> to_vertices(const garment::Garment& garment,
                                const std::vector<double>& per_triangle) {
  std::vector<double> sum(garment.vertex_count, 0.0), weight(garment.vertex_count, 0.0);
  for (std::size_t t = 0; t < garment.triangles.size(); ++t) {
    if (std::isnan(per_triangle[t])) continue;
    const double area = geometry::flat_area(garment.triangle_uv[t]);
    for (int v : garment.triangles[t]) {
      sum[v] += area * per_triangle[t];
      weight[v] += area;
    }
  }
  for (int v = 0; v < garment.vertex_count; ++v) sum[v] = weight[v] > 0 ? sum[v] / weight[v] : kNan;
  return sum;
}

std::vector<double> vertical_strain(const garment::Garment& garment,
                                    const std::vector<Vec3>& positions) {
  constexpr double kSameEdge = 1e-9;  // [m]
  const geometry::MeshTopology topology(garment.triangles);
  // In the pattern, from the edge's lower to its higher vertex.
  const auto flat = [&](const geometry::MeshTopology::Side& side) -> Vec2 {
    const auto& [t, k] = side;
    const Vec2 along = garment.triangle_uv[t][(k + 1) % 3] - garment.triangle_uv[t][k];
    return garment.triangles[t][k] < garment.triangles[t][(k + 1) % 3] ? along : Vec2(-along);
  };
  std::vector<double> sum(garment.vertex_count, 0.0), weight(garment.vertex_count, 0.0);
  for (int e = 0; e < topology.edge_count(); ++e) {
    const auto sides = topology.sides(e);
    const Vec2 first = flat(sides[0]);
    const double rest = first.norm();
    const bool seam = std::any_of(sides.begin() + 1, sides.end(), [&](const auto& side) {
      return garment.triangle_panel[side.triangle] != garment.triangle_panel[sides[0].triangle] ||
             (flat(side) - first).norm() > kSameEdge;
    });
    if (seam || rest <= 0) continue;
    const double cosine = first.y() / rest, w = cosine * cosine;
    const auto& [low, high] = topology.edges()[e];
    const double strain = (positions[high] - positions[low]).norm() / rest - 1;
    for (int v : {low, high}) {
      sum[v] += w * strain;
      weight[v] += w;
    }
  }
  constexpr double kEnough = 1e-6;  // only edges across the grain: no vertical strain to speak of
  for (int v = 0; v < garment.vertex_count; ++v)
    sum[v] = weight[v] > kEnough ? sum[v] / weight[v] : kNan;
  return sum;
}

std::vector<double> vertex_areas(const garment::Garment& garment) {
  std::vector<double> areas(garment.vertex_count, 0.0);
  for (std::size_t t = 0; t < garment.triangles.size(); ++t)
    for (int v : garment.triangles[t]) areas[v] += geometry::flat_area(garment.triangle_uv[t]) / 3;
  return areas;
}

}  // namespace loosefit::maps

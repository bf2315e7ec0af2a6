#include "loosefit/maps/strain.h"

#include <Eigen/Dense>
#include <cmath>
#include <limits>
#include <map>

namespace loosefit {
namespace {
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

double flat_area(const std::array<Vec2, 3>& uv) {
  const Vec2 e = uv[1] - uv[0], f = uv[2] - uv[0];
  return 0.5 * std::abs(e.x() * f.y() - e.y() * f.x());
}

TriangleStrain strain_of(const std::array<Vec2, 3>& uv, const Vec3& a, const Vec3& b,
                         const Vec3& c) {
  Mat2 flat;
  flat << uv[1] - uv[0], uv[2] - uv[0];
  if (flat_area(uv) <= 0) return {kNan, kNan, kNan, kNan};
  Eigen::Matrix<double, 3, 2> space;
  space << b - a, c - a;
  const Eigen::Matrix<double, 3, 2> gradient = space * flat.inverse();
  const double uu = gradient.col(0).squaredNorm(), vv = gradient.col(1).squaredNorm();
  const double uv_product = gradient.col(0).dot(gradient.col(1));
  // Eigenvalues of FᵀF.
  const double mean = 0.5 * (uu + vv), spread = std::hypot(0.5 * (uu - vv), uv_product);
  return {std::sqrt(uu) - 1, std::sqrt(vv) - 1, std::sqrt(mean + spread) - 1,
          std::sqrt(std::max(mean - spread, 0.0)) - 1};
}
}  // namespace

std::vector<TriangleStrain> triangle_strains(const Garment& garment,
                                             const std::vector<Vec3>& positions) {
  std::vector<TriangleStrain> strains;
  strains.reserve(garment.triangles.size());
  for (std::size_t t = 0; t < garment.triangles.size(); ++t) {
    const Triangle& corner = garment.triangles[t];
    strains.push_back(strain_of(garment.triangle_uv[t], positions[corner[0]], positions[corner[1]],
                                positions[corner[2]]));
  }
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

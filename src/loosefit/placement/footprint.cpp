#include "loosefit/placement/footprint.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "loosefit/geometry/closest_point.h"
#include "loosefit/maps/statistics.h"

namespace loosefit {
namespace {
constexpr int kSplit = 6;  // a triangle is sampled at the centres of 36 equal parts

struct Geometry {
  const Garment& garment;
  const std::vector<Vec3>& positions;
  const Vec3& corner(int t, int k) const { return positions[garment.triangles[t][k]]; }
  Vec3 point(int t, const Vec3& b) const {
    return b[0] * corner(t, 0) + b[1] * corner(t, 1) + b[2] * corner(t, 2);
  }
  double distance(int t, const Vec3& p) const {
    return (point(t, closest_barycentric(p, corner(t, 0), corner(t, 1), corner(t, 2))) - p).norm();
  }
};

/// Triangles reached from `start` over shared vertices without leaving the ball.
std::vector<int> connected(const Geometry& g, int start, const Vec3& centre, double radius) {
  std::vector<std::vector<int>> near_triangles(g.garment.vertex_count);
  for (int t = 0; t < static_cast<int>(g.garment.triangles.size()); ++t)
    if (g.distance(t, centre) <= radius)
      for (int v : g.garment.triangles[t]) near_triangles[v].push_back(t);
  std::set<int> found{start};
  std::vector<int> open{start};
  while (!open.empty()) {
    const int t = open.back();
    open.pop_back();
    for (int v : g.garment.triangles[t])
      for (int next : near_triangles[v])
        if (found.insert(next).second) open.push_back(next);
  }
  return {found.begin(), found.end()};
}
}  // namespace

Footprint footprint(const Garment& garment, const std::vector<Vec3>& positions, int triangle,
                    const Vec3& barycentric, double radius) {
  const Geometry g{garment, positions};
  const Vec3 centre = g.point(triangle, barycentric);
  Footprint result;
  for (int t : connected(g, triangle, centre, radius)) {
    const double part =
        triangle_area(g.corner(t, 0), g.corner(t, 1), g.corner(t, 2)) / (kSplit * kSplit);
    for (int i = 0; i < kSplit; ++i)
      for (int j = 0; j < kSplit - i; ++j)
        for (int down = 0; down < (i + j < kSplit - 1 ? 2 : 1); ++down) {
          const double third = (1.0 + down) / 3;
          const Vec3 b((i + third) / kSplit, (j + third) / kSplit,
                       1 - (i + j + 2 * third) / kSplit);
          if ((g.point(t, b) - centre).norm() <= radius) result.samples.push_back({t, b, part});
        }
  }
  if (result.samples.empty()) result.samples.push_back({triangle, barycentric, 1});
  return result;
}

FootprintValue average(const Footprint& footprint, const Garment& garment,
                       const std::vector<double>& vertex_values) {
  std::vector<double> values, weights;
  for (const Footprint::Sample& sample : footprint.samples) {
    double sum = 0, weight = 0;
    for (int k = 0; k < 3; ++k) {
      const double value = vertex_values[garment.triangles[sample.triangle][k]];
      if (std::isnan(value)) continue;
      sum += sample.barycentric[k] * value;
      weight += sample.barycentric[k];
    }
    values.push_back(weight > 0 ? sum / weight : std::numeric_limits<double>::quiet_NaN());
    weights.push_back(sample.area);
  }
  const MapStatistics s = statistics(values, weights);
  return {s.area_mean, s.p95};
}

}  // namespace loosefit

#include "loosefit/maps/curved_cloth.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "loosefit/geometry/flat_triangle.h"
#include "loosefit/geometry/triangle_mesh.h"

namespace loosefit::maps {
namespace {

constexpr int kIntervals = 6;       ///< of a triangle's edge: 25 places besides its corners
constexpr double kOnSkin = 0.001;   ///< nearest place of a triangle that lies on the skin [m]
constexpr double kMostTurn = 1;     ///< of the normals along an edge that counts as a bend
constexpr double kFreeShare = 1.0 / 3;

/// Distance to the nearest skin that faces as the triangle does, at the nearest of its places.
double nearest_place(const std::array<Vec3, 3>& corner, const body::PosedBody& body, double reach) {
  const Vec3 normal = (corner[1] - corner[0]).cross(corner[2] - corner[0]);
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= kIntervals; ++i)
    for (int j = 0; i + j <= kIntervals; ++j) {
      const int k = kIntervals - i - j;
      if (std::max({i, j, k}) == kIntervals) continue;
      const Vec3 p = (double(i) * corner[0] + double(j) * corner[1] + double(k) * corner[2]) /
                     double(kIntervals);
      const geometry::ClosestPoint hit = body.tree().query(p, std::min(reach, least));
      if (hit.triangle < 0) continue;
      const Triangle& t = body->surface.triangles[hit.triangle];
      const auto& x = body->surface.vertices;
      if ((x[t[1]] - x[t[0]]).cross(x[t[2]] - x[t[0]]).dot(normal) > 0)
        least = std::min(least, hit.distance);
    }
  return least;
}

}  // namespace

std::vector<CurvedTriangle> curved_triangles(const garment::Garment& garment,
                                             const std::vector<Vec3>& x,
                                             const std::vector<Vec3>& normals,
                                             const std::vector<double>& distances,
                                             const body::PosedBody& body) {
  std::vector<CurvedTriangle> curved(garment.triangles.size());
  tbb::parallel_for(std::size_t{0}, curved.size(), [&](std::size_t t) {
    const Triangle& corner = garment.triangles[t];
    CurvedTriangle& here = curved[t];
    double most = 0;
    for (int k = 0; k < 3; ++k) {
      const int a = corner[k], b = corner[(k + 1) % 3];
      const Vec3 edge = x[b] - x[a];
      const double length = edge.norm();
      if (!(length > 0)) continue;
      const double turn = (normals[b] - normals[a]).dot(edge) / length;
      here.bulge[k] = length / 8 * std::clamp(turn, -kMostTurn, kMostTurn);
      if (std::abs(here.bulge[k]) > std::abs(most)) most = here.bulge[k];
    }
    here.lift = kFreeShare * most;
    const double near =
        std::min({distances[corner[0]], distances[corner[1]], distances[corner[2]]});
    // Where the cloth bends around the skin and may lie on it.
    const double reach = kOnSkin + most;
    if (!(most > 0) || !(near < 2 * reach)) return;
    const double nearest = nearest_place({x[corner[0]], x[corner[1]], x[corner[2]]}, body, reach);
    if (nearest < reach)
      here.lift += (1 - kFreeShare) * std::min(most, most - (nearest - kOnSkin));
  });
  return curved;
}

double smooth_distance(const CurvedTriangle& triangle, const Vec3& b, double distance) {
  double bulge = 0;
  for (int k = 0; k < 3; ++k) bulge += 4 * b[k] * b[(k + 1) % 3] * triangle.bulge[k];
  return std::max(0.0, distance + bulge - triangle.lift);
}

std::vector<double> smooth_vertex_distances(const garment::Garment& garment,
                                            const std::vector<CurvedTriangle>& triangles,
                                            const std::vector<double>& distances) {
  std::vector<double> lift(distances.size(), 0), area(distances.size(), 0);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const double here = geometry::flat_area(garment.triangle_uv[t]);
    for (const int v : garment.triangles[t]) lift[v] += here * triangles[t].lift, area[v] += here;
  }
  std::vector<double> smooth(distances.size());
  for (std::size_t v = 0; v < smooth.size(); ++v)
    smooth[v] = std::max(0.0, distances[v] - (area[v] > 0 ? lift[v] / area[v] : 0.0));
  return smooth;
}

}  // namespace loosefit::maps

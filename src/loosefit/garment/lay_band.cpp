#include "loosefit/garment/lay_band.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "loosefit/geometry/flat_triangle.h"

namespace loosefit::garment {
namespace {

constexpr int kSamples = 8;  // per direction of a triangle

/// Where on a path a point of the panel is.
struct OnPath {
  double distance = std::numeric_limits<double>::infinity(), along = 0;  // [m]
  Vec2 direction = Vec2::Zero();
};

OnPath nearest(const std::vector<Vec2>& path, const Vec2& p) {
  OnPath best;
  double begin = 0;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const Vec2 way = path[i + 1] - path[i];
    const double length = way.norm();
    if (!(length > 0)) continue;
    const Vec2 direction = way / length;
    // Without rounded ends: what lies beyond an end is off the band.
    const double t = (p - path[i]).dot(direction);
    const bool first = i == 0, last = i + 2 == path.size();
    if (!(t < 0 && first) && !(t > length && last)) {
      const double on = std::clamp(t, 0.0, length),
                   distance = (p - path[i] - on * direction).norm();
      if (distance < best.distance) best = {distance, begin + on, direction};
    }
    begin += length;
  }
  return best;
}

double length_of(const std::vector<Vec2>& path) {
  double length = 0;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) length += (path[i + 1] - path[i]).norm();
  return length;
}

/// Edge of equilateral triangles of the panel's mean area [m].
double edge_of(const Garment& g, int panel) {
  double area = 0;
  int count = 0;
  for (std::size_t t = 0; t < g.triangles.size(); ++t)
    if (g.triangle_panel[t] == panel) area += geometry::flat_area(g.triangle_uv[t]), ++count;
  return count == 0 ? 0 : std::sqrt(4 / std::sqrt(3.0) * area / count);
}

/// Σ row_k u_k = the unit direction, for the flat corners u.
Vec3 row_of(const geometry::FlatCorners& flat, const Vec2& direction) {
  Eigen::Matrix2d edges;
  edges << flat[1] - flat[0], flat[2] - flat[0];
  const Vec2 weights = edges.inverse() * direction;
  return {-weights.sum(), weights.x(), weights.y()};
}

}  // namespace

void lay_band(Garment& garment, int panel, const Cable& cable) {
  const double length = length_of(cable.path);
  if (!(cable.axial_stiffness > 0) || !(length > 0)) return;
  const double edge = edge_of(garment, panel);
  const double half = 0.5 * std::max(cable.width, 0.5 * edge);
  const int parts = std::max(1, static_cast<int>(std::lround(length / edge)));
  const double step = length / parts;
  std::vector<fabric::BandPart> laid(parts);
  for (std::size_t t = 0; t < garment.triangles.size(); ++t) {
    if (garment.triangle_panel[t] != panel) continue;
    const geometry::FlatCorners& flat = garment.triangle_uv[t];
    const Vec2 middle = (flat[0] + flat[1] + flat[2]) / 3;
    double reach = half;
    for (const Vec2& corner : flat) reach = std::max(reach, half + (corner - middle).norm());
    if (nearest(cable.path, middle).distance > reach) {
      // Ends are cut off square: a triangle beyond one may still reach over it.
      const bool at_end = (middle - cable.path.front()).norm() < reach ||
                          (middle - cable.path.back()).norm() < reach;
      if (!at_end) continue;
    }
    // Equal sub-triangles, as covered_share.h.
    std::vector<int> hits(parts, 0);
    std::vector<Vec2> direction(parts, Vec2::Zero());
    for (int i = 0; i < kSamples; ++i)
      for (int j = 0; j < kSamples - i; ++j)
        for (const double third : {1.0 / 3, 2.0 / 3}) {
          if (third > 0.5 && i + j == kSamples - 1) continue;
          const double a = (i + third) / kSamples, b = (j + third) / kSamples;
          const OnPath at =
              nearest(cable.path, flat[0] + a * (flat[1] - flat[0]) + b * (flat[2] - flat[0]));
          if (at.distance > half) continue;
          const int part = std::min(parts - 1, static_cast<int>(at.along / step));
          ++hits[part];
          direction[part] += at.direction;
        }
    for (int part = 0; part < parts; ++part) {
      if (hits[part] == 0 || !(direction[part].norm() > 0)) continue;
      laid[part].triangles.push_back({static_cast<int>(t),
                                      row_of(flat, direction[part].normalized()),
                                      hits[part] * geometry::flat_area(flat)});
    }
  }
  for (fabric::BandPart& part : laid) {
    double area = 0;
    for (const fabric::BandTriangle& t : part.triangles) area += t.share;
    if (!(area > 0)) continue;
    for (fabric::BandTriangle& t : part.triangles) t.share /= area;
    part.length = step;
    part.stiffness = cable.axial_stiffness;
    part.pre_stretch = cable.pre_stretch;
    garment.bands.push_back(std::move(part));
  }
}

}  // namespace loosefit::garment

#include "loosefit/dress/front_neckline.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace loosefit::dress {
namespace {

constexpr int kNeckPoints = 12;
constexpr double kBelowChin = 0.02;  ///< room between chin and neckline [m]

/// Height of the chin: the lowest of the head in front of the neck, near the middle [m]; +∞ without
/// a head.
double chin_height(const body::Body& body) {
  constexpr double kNearMiddle = 0.02;
  double neck = 0, chin = std::numeric_limits<double>::infinity();
  int count = 0;
  const auto each = [&](body::Segment segment, const auto& take) {
    for (std::size_t v = 0; v < body.segment.size(); ++v) {
      const Vec3& p = body.surface.vertices[v];
      if (body.segment[v] == segment && std::abs(p[0]) < kNearMiddle) take(p);
    }
  };
  each(body::Segment::neck, [&](const Vec3& p) { neck += p[1], ++count; });
  if (count == 0) return chin;
  neck /= count;
  each(body::Segment::head, [&](const Vec3& p) {
    if (p[1] < neck) chin = std::min(chin, p[2]);
  });
  return chin;
}

/// Front neckline: straight across or, where that would lie before the chin or above it, a parabola
/// that hangs below it, but not lower than its length allows.
std::vector<Vec2> neckline(const Vec2& from, const Vec2& to, double length, double chin) {
  const double width = (to - from).norm();
  const double most = width * std::sqrt(0.375 * std::max(0.0, length / width - 1));
  const double sag = std::clamp(0.5 * (from[1] + to[1]) - (chin - kBelowChin), 0.0, most);
  if (sag == 0) return {from, to};
  std::vector<Vec2> line;
  for (int k = 0; k <= kNeckPoints; ++k) {
    const double s = double(k) / kNeckPoints;
    line.push_back(from + s * (to - from) - Vec2(0, 4 * s * (1 - s) * sag));
  }
  return line;
}

}  // namespace

double flat_length(const garment::Garment& g, const garment::Garment::EdgeChain& chain) {
  // Chain vertices carry pattern positions of their own panel in the triangles of that panel.
  std::map<int, Vec2> uv;
  for (std::size_t t = 0; t < g.triangles.size(); ++t)
    if (g.triangle_panel[t] == chain.panel)
      for (int k = 0; k < 3; ++k) uv[g.triangles[t][k]] = g.triangle_uv[t][k];
  double length = 0;
  for (std::size_t i = 1; i < chain.vertices.size(); ++i)
    length += (uv.at(chain.vertices[i]) - uv.at(chain.vertices[i - 1])).norm();
  return length;
}

std::vector<Vec2> front_neckline(double length, const body::Body& body, const Vec2& from,
                                 const Vec2& to) {
  return neckline(from, to, length, chin_height(body));
}

}  // namespace loosefit::dress

#include "loosefit/geometry/closest_point.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace loosefit::geometry {
namespace {

/// Nearest of the three edges: all there is of a triangle without area.
Vec3 on_edges(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3* corner[3] = {&a, &b, &c};
  Vec3 best = Vec3::UnitX();
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 3; ++k) {
    const int next = (k + 1) % 3;
    const Vec3 edge = *corner[next] - *corner[k];
    const double length2 = edge.squaredNorm();
    const double s = length2 > 0 ? std::clamp(edge.dot(p - *corner[k]) / length2, 0.0, 1.0) : 0.0;
    const double d2 = (*corner[k] + s * edge - p).squaredNorm();
    if (d2 >= least) continue;
    least = d2;
    best.setZero();
    best[k] = 1 - s;
    best[next] = s;
  }
  return best;
}

}  // namespace

Vec3 closest_barycentric(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = b - a, ac = c - a, ap = p - a;
  const double d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= 0 && d2 <= 0) return {1, 0, 0};
  const Vec3 bp = p - b;
  const double d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= 0 && d4 <= d3) return {0, 1, 0};
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) {
    const double v = d1 / (d1 - d3);
    return {1 - v, v, 0};
  }
  const Vec3 cp = p - c;
  const double d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= 0 && d5 <= d6) return {0, 0, 1};
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) {
    const double w = d2 / (d2 - d6);
    return {1 - w, 0, w};
  }
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
    const double w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    return {0, 1 - w, w};
  }
  const double denominator = va + vb + vc;
  constexpr double kFlat = 1e-20;  // sin² of the corner below which the face is only round-off
  if (denominator <= 0 || ab.cross(ac).squaredNorm() <= kFlat * ab.squaredNorm() * ac.squaredNorm())
    return on_edges(p, a, b, c);
  return {va / denominator, vb / denominator, vc / denominator};
}

ClosestPoint closest_point_brute_force(const TriangleMesh& mesh, const Vec3& p) {
  ClosestPoint best;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < static_cast<int>(mesh.triangles.size()); ++i) {
    const Triangle& t = mesh.triangles[i];
    const Vec3 &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
    const Vec3 weights = closest_barycentric(p, a, b, c);
    const Vec3 point = weights[0] * a + weights[1] * b + weights[2] * c;
    const double d2 = (p - point).squaredNorm();
    if (!(d2 < least)) continue;
    least = d2;
    best = {i, weights, point, std::sqrt(d2)};
  }
  return best;
}

}  // namespace loosefit::geometry

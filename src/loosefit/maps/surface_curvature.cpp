#include "loosefit/maps/surface_curvature.h"

#include <tbb/parallel_for.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "loosefit/geometry/least_squares.h"
#include "loosefit/geometry/principal_axes.h"

namespace loosefit::maps {
namespace {

/// Normals that are exact where all vertices round a corner lie on a sphere (Max 1999).
std::vector<Vec3> sphere_exact_normals(const geometry::TriangleMesh& surface) {
  std::vector<Vec3> normals(surface.vertices.size(), Vec3::Zero());
  for (const Triangle& t : surface.triangles)
    for (int k = 0; k < 3; ++k) {
      const Vec3& p = surface.vertices[t[k]];
      const Vec3 a = surface.vertices[t[(k + 1) % 3]] - p, b = surface.vertices[t[(k + 2) % 3]] - p;
      const double weight = a.squaredNorm() * b.squaredNorm();
      if (weight > 0) normals[t[k]] += a.cross(b) / weight;
    }
  for (Vec3& n : normals) {
    const double length = n.norm();
    if (length > 0) n /= length;
  }
  return normals;
}

/// κ of the quadric w = d·s + e·t − ½(A s² + 2 B s t + C t²) through the origin, (s, t, w) in the
/// frame of `normal`, that fits the points best.
Mat3 fitted_curvature(const std::vector<Vec3>& points, const Vec3& normal) {
  const auto count = static_cast<Eigen::Index>(points.size());
  if (count < 5) return Mat3::Zero();
  const Vec3 s = normal.unitOrthogonal(), t = normal.cross(s);
  double reach = 0;
  for (const Vec3& p : points) reach = std::max(reach, p.norm());
  Eigen::MatrixXd a(count, 5);
  Eigen::VectorXd b(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const double x = points[i].dot(s) / reach, y = points[i].dot(t) / reach;
    a.row(i) << x, y, -0.5 * x * x, -x * y, -0.5 * y * y;
    b[i] = points[i].dot(normal) / reach;
  }
  const Eigen::VectorXd c = geometry::least_squares(a, b);
  Eigen::Matrix<double, 3, 2> tangents;
  tangents << s + c[0] * normal, t + c[1] * normal;
  const Eigen::Matrix<double, 3, 2> dual = tangents * (tangents.transpose() * tangents).inverse();
  Mat2 form;
  form << c[2], c[3], c[3], c[4];
  form /= reach * std::sqrt(1 + c[0] * c[0] + c[1] * c[1]);
  return dual * form * dual.transpose();
}

void keep_once(std::vector<int>& indices) {
  std::sort(indices.begin(), indices.end());
  indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
}

Mat3 across(const Mat3& tensor, const Vec3& normal) {
  const Mat3 plane = Mat3::Identity() - normal * normal.transpose();
  return plane * tensor * plane;
}

}  // namespace

std::vector<Mat3> vertex_curvatures(const geometry::TriangleMesh& surface,
                                    const std::vector<char>& wanted) {
  const auto count = static_cast<int>(surface.vertices.size());
  const std::vector<Vec3> normals = sphere_exact_normals(surface);
  std::vector<std::vector<int>> ring(count);
  for (const Triangle& t : surface.triangles)
    for (int k = 0; k < 3; ++k)
      for (int other : {t[(k + 1) % 3], t[(k + 2) % 3]}) ring[t[k]].push_back(other);
  for (auto& r : ring) keep_once(r);
  std::vector<Mat3> curvatures(count, Mat3::Zero());
  tbb::parallel_for(0, count, [&](int v) {
    if (!wanted.empty() && !wanted[v]) return;
    std::vector<int> near = ring[v];
    for (int other : ring[v]) near.insert(near.end(), ring[other].begin(), ring[other].end());
    keep_once(near);
    std::vector<Vec3> offsets;
    for (int other : near)
      if (other != v && normals[other].dot(normals[v]) > 0)
        offsets.push_back(surface.vertices[other] - surface.vertices[v]);
    curvatures[v] = fitted_curvature(offsets, normals[v]);
  });
  return curvatures;
}

Mat3 curvature_at(const geometry::TriangleMesh& surface, const std::vector<Mat3>& vertex_curvatures,
                  const geometry::ClosestPoint& at, const Vec3& normal) {
  Mat3 sum = Mat3::Zero();
  const Triangle& corner = surface.triangles[at.triangle];
  for (int k = 0; k < 3; ++k) sum += at.barycentric[k] * vertex_curvatures[corner[k]];
  return across(sum, normal);
}

Mat3 offset_curvature(const Mat3& curvature, double distance) {
  const auto [k, axes] = geometry::principal_axes(0.5 * (curvature + curvature.transpose()));
  const Vec3 share = (1 + distance * k.array()).max(kLeastRadiusShare);
  return axes * (k.array() / share.array()).matrix().asDiagonal() * axes.transpose();
}

}  // namespace loosefit::maps

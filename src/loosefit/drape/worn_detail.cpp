#include "loosefit/drape/worn_detail.h"

#include <Eigen/Geometry>

#include "loosefit/geometry/nearest_rotation.h"

namespace loosefit::drape {
namespace {

/// Σ edge now · edge beforeᵀ of a triangle; its normal counts as an edge as long as those.
Mat3 correlation(const Triangle& t, const std::vector<Vec3>& before, const std::vector<Vec3>& now) {
  Mat3 sum = Mat3::Zero();
  double length2 = 0;
  for (int k = 0; k < 3; ++k) {
    const Vec3 from = before[t[(k + 1) % 3]] - before[t[k]], to = now[t[(k + 1) % 3]] - now[t[k]];
    sum += to * from.transpose();
    length2 += from.squaredNorm() / 3;
  }
  const auto normal = [&](const std::vector<Vec3>& x) -> Vec3 {
    return (x[t[1]] - x[t[0]]).cross(x[t[2]] - x[t[0]]).normalized();
  };
  return sum + length2 * normal(now) * normal(before).transpose();
}

}  // namespace

std::vector<Vec3> on_coarse_surface(const std::vector<std::array<int, 2>>& parents,
                                    const std::vector<Vec3>& coarse) {
  std::vector<Vec3> fine(parents.size());
  for (std::size_t i = 0; i < parents.size(); ++i)
    fine[i] = 0.5 * (coarse[parents[i][0]] + coarse[parents[i][1]]);
  return fine;
}

std::vector<Vec3> turned_detail(const std::vector<Triangle>& triangles,
                                const std::vector<Vec3>& before, const std::vector<Vec3>& fine,
                                const std::vector<Vec3>& now) {
  std::vector<Mat3> round(before.size(), Mat3::Zero());
  for (const Triangle& t : triangles) {
    const Mat3 own = correlation(t, before, now);
    for (int v : t) round[v] += own;
  }
  std::vector<Vec3> detail(before.size());
  for (std::size_t i = 0; i < before.size(); ++i)
    detail[i] = geometry::nearest_rotation(round[i]) * (fine[i] - before[i]);
  return detail;
}

}  // namespace loosefit::drape

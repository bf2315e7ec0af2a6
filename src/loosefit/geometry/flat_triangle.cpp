#include "loosefit/geometry/flat_triangle.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

namespace loosefit::geometry {

double flat_area(const FlatCorners& flat) {
  return 0.5 * std::abs(cross(flat[1] - flat[0], flat[2] - flat[0]));
}

std::vector<double> flat_areas(const std::vector<FlatCorners>& flat) {
  std::vector<double> areas;
  areas.reserve(flat.size());
  for (const FlatCorners& triangle : flat) areas.push_back(flat_area(triangle));
  return areas;
}

double shortest_height(const std::vector<FlatCorners>& flat) {
  double least = 1e9;
  for (const auto& [a, b, c] : flat) {
    const double twice = std::abs(cross(b - a, c - a));
    least = std::min(least, twice / std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()}));
  }
  return least;
}

DeformationGradient deformation_gradient(const FlatCorners& flat, const Triangle& corner,
                                         const std::vector<Vec3>& positions) {
  if (flat_area(flat) <= 0)
    return DeformationGradient::Constant(std::numeric_limits<double>::quiet_NaN());
  Mat2 pattern;
  pattern << flat[1] - flat[0], flat[2] - flat[0];
  DeformationGradient space;
  space << positions[corner[1]] - positions[corner[0]], positions[corner[2]] - positions[corner[0]];
  return space * pattern.inverse();
}

}  // namespace loosefit::geometry

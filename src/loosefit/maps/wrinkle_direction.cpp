#include "loosefit/maps/wrinkle_direction.h"

#include <Eigen/Geometry>
#include <Eigen/SparseCholesky>
#include <cmath>
#include <limits>

#include "loosefit/base/error.h"
#include "loosefit/body/body_frame.h"
#include "loosefit/geometry/flat_triangle.h"

namespace loosefit::maps {
namespace {
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr int kSteps = 4;  // one implicit step has a long tail and would eat wide folds

using Sparse = Eigen::SparseMatrix<double>;

/// Lumped mass M and stiffness L of linear elements on the flat, sewn cloth; a vertex that no
/// triangle touches stays as it is.
Sparse diffusion_matrix(const garment::Garment& garment, double time, Eigen::VectorXd& mass) {
  mass = Eigen::VectorXd::Zero(garment.vertex_count);
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t t = 0; t < garment.triangles.size(); ++t) {
    const auto& uv = garment.triangle_uv[t];
    const Triangle& corner = garment.triangles[t];
    const double twice_area = std::abs(geometry::cross(uv[1] - uv[0], uv[2] - uv[0]));
    if (!(twice_area > 0)) continue;
    for (int k = 0; k < 3; ++k) {
      mass[corner[k]] += twice_area / 6;
      const int i = corner[(k + 1) % 3], j = corner[(k + 2) % 3];
      const Vec2 a = uv[(k + 1) % 3] - uv[k], b = uv[(k + 2) % 3] - uv[k];
      const double weight = 0.5 * time * a.dot(b) / twice_area;  // half the cotangent at k
      entries.insert(entries.end(),
                     {{i, i, weight}, {j, j, weight}, {i, j, -weight}, {j, i, -weight}});
    }
  }
  for (int v = 0; v < garment.vertex_count; ++v) {
    if (mass[v] == 0) mass[v] = 1;
    entries.emplace_back(v, v, mass[v]);
  }
  Sparse matrix(garment.vertex_count, garment.vertex_count);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

}  // namespace

std::vector<Vec3> smoothed_normals(const garment::Garment& garment,
                                   const std::vector<Vec3>& normals, double width) {
  Eigen::VectorXd mass;
  const Eigen::SimplicialLDLT<Sparse> solver(
      diffusion_matrix(garment, 0.5 * width * width / kSteps, mass));
  if (solver.info() != Eigen::Success)
    throw Error("wrinkles: the flat pattern cannot be smoothed over");
  Eigen::MatrixX3d field(garment.vertex_count, 3);
  for (int v = 0; v < garment.vertex_count; ++v) field.row(v) = normals[v];
  for (int step = 0; step < kSteps; ++step) field = solver.solve(mass.asDiagonal() * field).eval();
  std::vector<Vec3> smooth;
  for (int v = 0; v < garment.vertex_count; ++v)
    smooth.push_back(Vec3(field.row(v)).stableNormalized());
  return smooth;
}

std::vector<Vec2> wrinkle_slopes(const garment::Garment& garment, const WornGarment& worn,
                                 double width) {
  const std::vector<Vec3> smooth = smoothed_normals(garment, worn.normals, width);
  std::vector<Vec2> slopes(garment.vertex_count, Vec2::Constant(kNan));
  for (int v = 0; v < garment.vertex_count; ++v) {
    const body::SurfaceFrame frame = body::surface_frame(smooth[v], worn.segment_axes[v]);
    if (!frame.has_direction || !(smooth[v].squaredNorm() > 0)) continue;
    const Vec3 n = frame.axes.transpose() * worn.normals[v];
    const double sine = std::hypot(n.x(), n.y());
    slopes[v] = n.head<2>() * (sine > 0 ? std::atan2(sine, n.z()) / sine : 1);
  }
  return slopes;
}

WrinkleDirection wrinkle_direction(const std::vector<Vec2>& slopes,
                                   const std::vector<double>& areas) {
  Mat2 tensor = Mat2::Zero();
  double area = 0;
  for (std::size_t i = 0; i < slopes.size(); ++i) {
    if (!slopes[i].allFinite()) continue;
    tensor += areas[i] * slopes[i] * slopes[i].transpose();
    area += areas[i];
  }
  if (!(area > 0)) return {kNan, kNan, kNan};
  tensor /= area;
  const double across = tensor(0, 0) - tensor(1, 1), shear = 2 * tensor(0, 1);
  const double trace = tensor.trace();
  // The slope's first axis stands at this angle to s, the folds at the same to a.
  return {0.5 * std::atan2(shear, across), trace > 0 ? std::hypot(across, shear) / trace : 0,
          std::sqrt(trace)};
}

std::map<body::Region, WrinkleDirection> regional_wrinkles(const garment::Garment& garment,
                                                           const WornGarment& worn, double width) {
  const std::vector<Vec2> slopes = wrinkle_slopes(garment, worn, width);
  std::map<body::Region, WrinkleDirection> result;
  for (body::Region region : body::all_regions()) {
    std::vector<Vec2> own;
    std::vector<double> areas;
    for (std::size_t v = 0; v < slopes.size(); ++v)
      if (worn.regions[v] == region) {
        own.push_back(slopes[v]);
        areas.push_back(worn.areas[v]);
      }
    const WrinkleDirection found = wrinkle_direction(own, areas);
    if (std::isfinite(found.slope)) result[region] = found;
  }
  return result;
}

}  // namespace loosefit::maps

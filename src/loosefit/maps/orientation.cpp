#include "loosefit/maps/orientation.h"

#include <Eigen/Geometry>
#include <cmath>
#include <limits>

#include "loosefit/base/check.h"
#include "loosefit/body/body_frame.h"
#include "loosefit/maps/strain.h"

namespace loosefit::maps {
namespace {
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
}  // namespace

double Orientation::tilt_across() const {
  return std::cos(twist) * tilt_sagittal + std::sin(twist) * tilt_lateral;
}

double Orientation::tilt_along() const {
  return std::cos(twist) * tilt_lateral - std::sin(twist) * tilt_sagittal;
}

double rotation_angle(const Mat3& r) {
  const Vec3 twice_sine(r(2, 1) - r(1, 2), r(0, 2) - r(2, 0), r(1, 0) - r(0, 1));
  return std::atan2(twice_sine.norm(), r.trace() - 1);
}

Orientation orientation_of(const Mat3& relative) {
  LOOSEFIT_ASSERT(!relative.allFinite() ||
                  (relative.isUnitary(1e-6) && relative.determinant() > 0));
  const Vec3 n = relative.col(2);  // the garment's normal in the body frame
  const double sine = std::hypot(n.x(), n.y());
  Orientation o;
  o.angular_deviation = std::atan2(sine, n.z());
  o.rotation = rotation_angle(relative);
  const Eigen::Quaterniond q(relative);
  const double upright = std::hypot(q.w(), q.z());  // cos(AD/2)
  constexpr double kOpposite = 1e-9;
  if (upright < kOpposite) {
    o.tilt_sagittal = o.tilt_lateral = o.twist = kNan;
    return o;
  }
  // τ = AD (e₃ × n)/|e₃ × n|; a limit of one where the normals agree.
  const double per_sine = sine > 0 ? o.angular_deviation / sine : 1;
  o.tilt_sagittal = -n.y() * per_sine;
  o.tilt_lateral = n.x() * per_sine;
  o.twist = 2 * std::atan2(q.w() < 0 ? -q.z() : q.z(), std::abs(q.w()));
  return o;
}

Mat3 triangle_frame(const garment::Garment& garment, int triangle,
                    const std::vector<Vec3>& positions, const Vec2& direction) {
  const Triangle& c = garment.triangles[triangle];
  const Vec3 normal = geometry::triangle_normal(positions[c[0]], positions[c[1]], positions[c[2]]);
  const Vec3 image = garment_gradient(garment, triangle, positions) * direction;
  const double length = image.norm();
  Mat3 frame = Mat3::Constant(kNan);
  if (!(length > 0) || !(normal.squaredNorm() > 0)) return frame;
  const Vec3 a = image / length;
  frame << a.cross(normal), a, normal;
  return frame;
}

std::vector<Mat3> vertex_frames(const garment::Garment& garment, const std::vector<Vec3>& positions,
                                const std::vector<Vec3>& normals, const Vec2& direction) {
  std::vector<Vec3> image(garment.vertex_count, Vec3::Zero());
  for (int t = 0; t < static_cast<int>(garment.triangles.size()); ++t) {
    const double area = geometry::flat_area(garment.triangle_uv[t]);
    if (!(area > 0)) continue;
    const Vec3 along = garment_gradient(garment, t, positions) * direction;
    for (int v : garment.triangles[t])
      if (garment.vertex_panel[v] == garment.triangle_panel[t]) image[v] += area * along;
  }
  std::vector<Mat3> frames(garment.vertex_count, Mat3::Constant(kNan));
  for (int v = 0; v < garment.vertex_count; ++v) {
    const Vec3 a = image[v] - image[v].dot(normals[v]) * normals[v];
    const double length = a.norm();
    if (!(length > 0) || !(normals[v].squaredNorm() > 0)) continue;
    frames[v] << (a / length).cross(normals[v]), a / length, normals[v];
  }
  return frames;
}

double angle_between(const Vec3& a, const Vec3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

std::vector<Orientation> vertex_orientations(const garment::Garment& garment,
                                             const std::vector<Vec3>& positions,
                                             const WornGarment& worn, const Vec2& direction) {
  const std::vector<Mat3> frames = vertex_frames(garment, positions, worn.normals, direction);
  std::vector<Orientation> orientations(garment.vertex_count, {kNan, kNan, kNan, kNan, kNan});
  for (int v = 0; v < garment.vertex_count; ++v) {
    const body::SurfaceFrame body =
        body::surface_frame(worn.partners[v].normal, worn.segment_axes[v]);
    if (body.has_direction && frames[v].allFinite())
      orientations[v] = orientation_of(body.axes.transpose() * frames[v]);
  }
  return orientations;
}

}  // namespace loosefit::maps

#include "loosefit/io/garmentcode_frame.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace loosefit::io {

Mat3 frame_from_y_up() {
  Mat3 frame;
  frame << 1, 0, 0, 0, 0, -1, 0, 1, 0;
  return frame;
}

Mat3 rotation_from_euler_deg(const Vec3& angles) {
  return (Eigen::AngleAxisd(radians(angles.z()), Vec3::UnitZ()) *
          Eigen::AngleAxisd(radians(angles.y()), Vec3::UnitY()) *
          Eigen::AngleAxisd(radians(angles.x()), Vec3::UnitX()))
      .toRotationMatrix();
}

Vec3 euler_deg_from_rotation(const Mat3& r) {
  const double b = std::asin(std::clamp(-r(2, 0), -1.0, 1.0));
  double a = 0, c = 0;
  if (std::abs(r(2, 0)) < 1 - 1e-12) {
    a = std::atan2(r(2, 1), r(2, 2));
    c = std::atan2(r(1, 0), r(0, 0));
  } else {
    a = std::atan2(-r(1, 2), r(1, 1));
  }
  Vec3 angles(degrees(a), degrees(b), degrees(c));
  for (double& angle : angles) {
    // Rounding noise of the matrix would print as 1e-15 degrees.
    if (std::abs(angle - std::round(angle)) < 1e-10) angle = std::round(angle);
    angle += 0.0;  // −0 → 0
  }
  return angles;
}

}  // namespace loosefit::io

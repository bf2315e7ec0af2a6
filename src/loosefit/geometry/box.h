#pragma once
#include <Eigen/Geometry>
#include <cmath>
#include <limits>

namespace loosefit::geometry {

using Box3 = Eigen::AlignedBox3d;

/// Nearest single precision number that is not above x, and not below it.
inline float round_down(double x) {
  const auto f = static_cast<float>(x);
  return f > x ? std::nextafter(f, -std::numeric_limits<float>::infinity()) : f;
}
inline float round_up(double x) { return -round_down(-x); }

}  // namespace loosefit::geometry

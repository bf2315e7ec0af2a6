#pragma once
#include <Eigen/Core>
#include <array>
#include <vector>

namespace loosefit {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;
using Mat2 = Eigen::Matrix2d;
using Mat3 = Eigen::Matrix3d;

/// Three corner indices, counter-clockwise seen from outside.
using Triangle = std::array<int, 3>;

inline constexpr double kPi = 3.14159265358979323846;
inline constexpr double kGravity = 9.80665;  ///< m/s², standard gravity.

inline constexpr double radians(double degrees) { return degrees * kPi / 180.0; }
inline constexpr double degrees(double radians) { return radians * 180.0 / kPi; }

}  // namespace loosefit

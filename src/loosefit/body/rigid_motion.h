#pragma once
#include <Eigen/Geometry>

namespace loosefit::body {

/// Rotation and shift [m]. Without Eigen's alignment, which depends on the processor that a file is
/// compiled for: structs that hold one look alike to all who link the library.
using RigidMotion = Eigen::Transform<double, 3, Eigen::Isometry, Eigen::DontAlign>;

}  // namespace loosefit::body

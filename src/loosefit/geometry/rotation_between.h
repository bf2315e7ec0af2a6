#pragma once
#include <Eigen/Geometry>

#include "loosefit/base/types.h"

namespace loosefit::geometry {

/// The shortest turn that brings the direction of `from` into that of `to` (neither zero): half a
/// turn about any axis across where they are opposite. Eigen's own finds that axis by a singular
/// value decomposition, which costs every file that uses it seconds to compile.
Eigen::Quaterniond rotation_between(const Vec3& from, const Vec3& to);

}  // namespace loosefit::geometry

#pragma once
#include <optional>
#include <vector>

#include "loosefit/solver/particle_system.h"
#include "loosefit/solver/rest_tolerance.h"

namespace loosefit::drape {

/// How far a drape is from rest, told by the next Newton step with the exact Hessian.
struct LeftToGo {
  double move = 0;  ///< of the particle that goes farthest [m]
  double turn = 0;  ///< of vertex normals, 99th percentile [rad]
  bool is_grade_b() const { return move <= solver::kLeftToMove && turn <= solver::kLeftToTurn; }
};

/// Nothing where the Hessian is not positive definite: then the step says nothing. Friction and
/// contact sets as the last begin_step left them. One factorisation. Leaves the plate tangent set.
std::optional<LeftToGo> left_to_go(const solver::ParticleSystem& system,
                                   const std::vector<Triangle>& triangles,
                                   const std::vector<Vec3>& x);

}  // namespace loosefit::drape

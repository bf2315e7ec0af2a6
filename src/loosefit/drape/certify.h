#pragma once
#include "loosefit/body/posed_body.h"
#include "loosefit/drape/cloth_model.h"
#include "loosefit/drape/drape.h"

namespace loosefit::drape {

/// Measures the force balance, which may be up to `allowed_residual`, and tests for intersections
/// with exact predicates, of all layers. `stop`: why settling ended.
Certificate certify(ClothModel& model, const std::vector<Vec3>& x, const body::PosedBody& body,
                    const Stop& stop, double allowed_residual = solver::kRestTolerance);

}  // namespace loosefit::drape

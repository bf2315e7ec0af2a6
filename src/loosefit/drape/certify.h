#pragma once
#include "loosefit/body/posed_body.h"
#include "loosefit/drape/cloth_model.h"
#include "loosefit/drape/drape.h"

namespace loosefit {

/// Measures the force balance and tests for intersections with exact predicates, of all layers.
Certificate certify(ClothModel& model, const std::vector<Vec3>& x, const PosedBody& body,
                    const std::string& stop_reason);

}  // namespace loosefit

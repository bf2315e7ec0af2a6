#pragma once
#include "loosefit/body/posed_body.h"
#include "loosefit/drape/cloth_model.h"
#include "loosefit/drape/drape.h"

namespace loosefit {

/// Looks where the forces at x do not balance and what cuts. The model must stand as `certify` left
/// it there. `layers`: its garments, innermost first; vertices and triangles are numbered in
/// theirs.
Unsettled explain_unsettled(ClothModel& model, const std::vector<const Garment*>& layers,
                            const std::vector<Vec3>& x, const PosedBody& body,
                            const Certificate& certificate);

}  // namespace loosefit

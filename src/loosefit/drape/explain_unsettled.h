#pragma once
#include "loosefit/body/posed_body.h"
#include "loosefit/drape/cloth_model.h"
#include "loosefit/drape/drape.h"

namespace loosefit::drape {

/// Looks where the forces at x do not balance and what cuts. The model must stand as `certify` left
/// it there. `layers`: its garments, innermost first; vertices and triangles are numbered in
/// theirs.
Unsettled explain_unsettled(ClothModel& model, const std::vector<const garment::Garment*>& layers,
                            const std::vector<Vec3>& x, const body::PosedBody& body,
                            const Certificate& certificate);

}  // namespace loosefit::drape

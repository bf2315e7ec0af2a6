#pragma once
#include <vector>

#include "loosefit/body/body.h"
#include "loosefit/garment/garment.h"

namespace loosefit::render {

/// What pictures show of the wearer: a closed dress form without anatomy, for people are not the
/// subject and nobody is shown undressed. Trunk and limbs are a smooth form (smooth_skin.h) that
/// keeps within the cloth (clear_of_cloth.h), hands are mittens, feet a shoemaker's lasts.
///
/// How much of it there is (form_extent.h): what reaches below the crotch has legs and feet, in any
/// posture. Above that tops have a form that ends inside the cloth, or at the hips if the cloth
/// ends well above, with lids; a lifted thigh then ends in a stub. Trousers and skirts have a trunk
/// without arms, unless those are lifted. A hood has an egg in it; otherwise the neck ends in a
/// lid. A body without joints is cut at the hem, and there, only. `under`: all that is worn under
/// the garment; may be empty.
geometry::TriangleMesh mannequin(const body::Body& body, const garment::Garment& garment,
                                 const std::vector<Vec3>& positions,
                                 const geometry::TriangleMesh& under = {});

}  // namespace loosefit::render

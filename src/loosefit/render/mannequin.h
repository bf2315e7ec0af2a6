#pragma once
#include <vector>

#include "loosefit/body/body.h"
#include "loosefit/garment/garment.h"

namespace loosefit::render {

/// The part of the body that pictures show: a dress form. The head is cut off above the neck, and
/// below the garment's hem the body ends inside the cloth, for faces and anatomy are not the
/// subject and nobody is shown undressed. What hangs down to the lower legs has a form with legs
/// and a shoemaker's lasts for feet. Arms and hands stay; a lifted thigh ends in a stub with a lid,
/// and the form then at the lowest point of the hem. Above what ends below the middle of the trunk,
/// trousers or a skirt, the form ends too, with a lid and without arms, unless something else is
/// worn there (`under`: positions of all of that). A body without joints is cut at the hem, and
/// there, only.
geometry::TriangleMesh mannequin(const body::Body& body, const garment::Garment& garment,
                                 const std::vector<Vec3>& positions,
                                 const std::vector<Vec3>& under = {});

}  // namespace loosefit::render

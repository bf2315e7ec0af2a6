#pragma once
#include <vector>

#include "loosefit/body/body.h"
#include "loosefit/garment/garment.h"

namespace loosefit::render {

/// The part of the body that pictures show: a dress form. The head is cut off above the neck, and
/// below the garment's hem the body ends inside the cloth, for faces and anatomy are not the
/// subject and nobody is shown undressed. Arms and hands stay; a lifted thigh ends in a stub with a
/// lid, and the form then at the lowest point of the hem. A body without joints is cut at the hem
/// only.
geometry::TriangleMesh mannequin(const body::Body& body, const garment::Garment& garment,
                                 const std::vector<Vec3>& positions);

}  // namespace loosefit::render

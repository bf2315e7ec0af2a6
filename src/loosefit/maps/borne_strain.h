#pragma once
#include <vector>

#include "loosefit/garment/garment.h"
#include "loosefit/geometry/flat_triangle.h"

namespace loosefit::maps {

/// F of every triangle with the strains of warp and weft that its cloth bears, from pattern
/// (u weft, v warp) to space.
///
/// The energy of the cloth sees means of both strains round vertices (fabric/strain_patch.h);
/// single triangles alternate about them by up to one per cent. So the columns of F have the
/// lengths of the mean over the triangle's corners of those means; their directions, and with them
/// the trellis shear angle, are the triangle's own. NaN for a triangle without flat area.
std::vector<geometry::DeformationGradient> borne_gradients(const garment::Garment& garment,
                                                           const std::vector<Vec3>& positions);

}  // namespace loosefit::maps

#pragma once
#include "loosefit/fabric/material.h"
#include "loosefit/garment/garment.h"

namespace loosefit::garment {

/// Bending rigidity of a turned hem, times that of one layer: between 2, two layers that slide on
/// each other, and 8, two layers that do not. The stitches hold them along two lines (judgement).
inline constexpr double kHemBending = 4;

/// Gives the triangles of sewn panels what their pieces are made of (Panel::cloth) and the second
/// layer of hems (PanelEdge::finish): mass, stiffness in the plane, isotropic bending rigidity on
/// top of the fabric's, √(B_u B_v) for each layer more. A triangle that a hem covers in part gets
/// that part. `garment` is made from `pattern` and has plain cloth everywhere.
void thicken(Garment& garment, const pattern::Pattern& pattern, const fabric::Material& material);

}  // namespace loosefit::garment

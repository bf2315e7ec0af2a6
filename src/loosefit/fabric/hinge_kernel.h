#pragma once
#include "loosefit/particles/tile.h"

namespace loosefit::fabric {

/// Points of a tile of hinges, ordered as for `dihedral`.
using HingePoints = std::array<std::array<particles::TileRow, 3>, 4>;

/// ∇θ of a tile of hinges: rows ∂θ/∂x2, ∂θ/∂x3 and the shares s_i of the edge, from x0, at which
/// the feet of x2 and x3 lie: ∂θ/∂x1 = −(s_1 ∂θ/∂x2 + s_2 ∂θ/∂x3), and all four add up to zero.
using HingeGradient = std::array<particles::TileRow, 8>;

/// Dihedral angles as `dihedral_angle`, to 4e-16 of their value, without branches.
void hinge_angles(const HingePoints& x, particles::TileRow& angle);
void hinge_angles(const HingePoints& x, particles::TileRow& angle, HingeGradient& gradient);

/// scale ∇θ: rows 3 point + coordinate.
void hinge_forces(const HingeGradient& gradient, const particles::TileRow& scale,
                  std::array<particles::TileRow, 12>& out);

}  // namespace loosefit::fabric

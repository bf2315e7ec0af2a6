#pragma once
#include "loosefit/fabric/plane_law.h"

namespace loosefit::fabric {

/// A tile of flat triangles; missing ones at the end have weight 0.
struct MembraneTile {
  std::array<particles::TileIndex, 3> corner;
  std::array<particles::TileRow, 3> ru, rv;  ///< gradients of the shape functions [1/m]
  particles::TileRow weight;                 ///< flat area times stiffness factor [m²]
};

/// Images of the unit weft and warp vectors and the strains (ε_uu, ε_vv, γ).
struct MembraneStrain {
  std::array<particles::TileRow, 3> u, v, strain;
};

using TrianglePoints = std::array<std::array<particles::TileRow, 3>, 3>;

void membrane_strain(const MembraneTile& tile, const TrianglePoints& x, MembraneStrain& out);

/// ∂W/∂x: rows 3 corner + coordinate [N].
void membrane_gradient(const MembraneTile& tile, const MembraneStrain& s, const PlaneRows& stress,
                       std::array<particles::TileRow, 9>& out);

/// Second derivatives: blocks (0,0) (1,0) (1,1) (2,0) (2,1) (2,2), column by column [N/m].
/// Compressive stress counts in the share `compression`: 1 is exact; with 0 only the tensile part
/// is kept (Volino et al. 2009), and with C ⪰ 0 the result is positive semi-definite.
void membrane_blocks(const MembraneTile& tile, const MembraneStrain& s, const PlaneRows& stress,
                     const PlaneTangent& c, double compression,
                     std::array<particles::TileRow, 54>& out);

}  // namespace loosefit::fabric

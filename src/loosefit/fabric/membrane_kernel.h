#pragma once
#include "loosefit/particles/tile.h"

namespace loosefit {

/// A tile of flat triangles; missing ones at the end have weight 0.
struct MembraneTile {
  std::array<TileIndex, 3> corner;
  std::array<TileRow, 3> ru, rv;  ///< gradients of the shape functions [1/m]
  TileRow weight;                 ///< flat area times stiffness factor [m²]
};

/// Images of the unit weft and warp vectors and the strains (ε_uu, ε_vv, γ).
struct MembraneStrain {
  std::array<TileRow, 3> u, v, strain;
};

/// Symmetric 3 × 3 tangent whose shear does not couple: C_uu, C_vv, C_uv, C_ss [N/m].
using MembraneTangent = std::array<TileRow, 4>;

/// Response per flat area.
struct MembraneResponse {
  TileRow energy;                 ///< [J/m²]
  std::array<TileRow, 3> stress;  ///< s_uu, s_vv, s_uv [N/m]
};

using TrianglePoints = std::array<std::array<TileRow, 3>, 3>;

void membrane_strain(const MembraneTile& tile, const TrianglePoints& x, MembraneStrain& out);

/// Adds ½ share dᵀ C d and its derivative, d = strain − start.
void add_quadratic(const MembraneTangent& c, const std::array<TileRow, 3>& strain,
                   const std::array<TileRow, 3>& start, double share, MembraneResponse& out);

/// Forces −∂W/∂x with the opposite sign: rows 3 corner + coordinate [N].
void membrane_gradient(const MembraneTile& tile, const MembraneStrain& s,
                       const std::array<TileRow, 3>& stress, std::array<TileRow, 9>& out);

/// Second derivatives: blocks (0,0) (1,0) (1,1) (2,0) (2,1) (2,2), column by column [N/m].
/// `definite` keeps only the tensile part of the stress (Volino et al. 2009); with C ⪰ 0 the
/// result is positive semi-definite.
void membrane_blocks(const MembraneTile& tile, const MembraneStrain& s,
                     const std::array<TileRow, 3>& stress, const MembraneTangent& c, bool definite,
                     std::array<TileRow, 54>& out);

}  // namespace loosefit

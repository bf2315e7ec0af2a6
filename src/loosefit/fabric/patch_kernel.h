#pragma once
#include "loosefit/fabric/curvature_patch.h"
#include "loosefit/fabric/plane_law.h"

namespace loosefit::fabric {

/// A tile of curvature patches; missing ones at the end have area 0.
struct PatchTile {
  std::array<particles::TileIndex, 9>
      hinge;                   ///< where there is none: a place of which the angle stays 0
  std::array<PlaneRows, 9> s;  ///< columns of S [1/m per rad]
  PlaneTangent rigidity;       ///< area times D [N m³]
  particles::TileRow area;     ///< flat [m²]
};

/// κ = S θ; angle[hinge] [rad].
void patch_curvature(const PatchTile& tile, const double* angle, PlaneRows& curvature);

/// Moments about the hinges, Sᵀ (A M): out[k] about hinge k [J/rad].
void patch_moments(const PatchTile& tile, const PlaneRows& stress,
                   std::array<particles::TileRow, 9>& out);

}  // namespace loosefit::fabric

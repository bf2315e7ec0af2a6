#pragma once
#include "loosefit/particles/tile.h"

namespace loosefit::fabric {

/// Laws between three strains, or curvatures, of a tile of triangles and their work conjugates.
using PlaneRows = std::array<particles::TileRow, 3>;

/// Symmetric 3 × 3 tangent whose shear (twist) does not couple: C_uu, C_vv, C_uv, C_ss.
using PlaneTangent = std::array<particles::TileRow, 4>;

struct PlaneResponse {
  particles::TileRow energy;
  PlaneRows stress;
};

inline constexpr PlaneRows kZeroRows{};

/// Adds ½ share dᵀ C d and its derivative, d = strain − start.
void add_quadratic(const PlaneTangent& c, const PlaneRows& strain, const PlaneRows& start,
                   double share, PlaneResponse& out);

}  // namespace loosefit::fabric

#pragma once
#include <cmath>

#include "loosefit/maps/map_definition.h"

namespace loosefit::maps {

/// Trellis shear: by how much the angle between weft and warp has left the right angle that they
/// have in the flat pattern [rad]. Positive where the warp leans towards the weft, so that simple
/// shear F = [1 γ; 0 1] reads atan γ: the angle φ over which KES-F draws the shear force (Kawabata
/// 1980). Free of the stretch along the yarns; NaN without flat area.
inline double trellis_shear(const geometry::DeformationGradient& f) {
  const Vec3 weft = f.col(0), warp = f.col(1);
  return std::atan2(weft.dot(warp), weft.cross(warp).norm());
}

/// Shear of the fabric, the deformation by which woven cloth fits a curved body at all.
inline MapDefinition trellis_shear_map() {
  constexpr double kRange = 15;  // KES-F shears to 8°; twice as far is shown [deg]
  return {.name = "shear",
          .arrays = {{.style = {.array = "shear_angle_deg",
                                .title = "Trellis shear angle",
                                .unit = "deg",
                                .range_low = -kRange,
                                .range_high = kRange,
                                .map = "shear",
                                .diverging = true},
                      .meaning =
                          "By how much the angle between weft and warp has left the right angle "
                          "that they have in the flat pattern: positive where the warp leans "
                          "towards the weft. Simple shear by γ reads atan γ, whatever the stretch "
                          "along the yarns, and is the greatest part of the principal strain of "
                          "woven cloth. Leads and strain sensors on the bias are stretched by it "
                          "(about tan(φ/2) at 45°); a knit gives way at small force, a woven "
                          "locks.",
                      .formula = "φ = atan2(F u · F v, |F u × F v|), F = ∂x/∂(u, v)",
                      .source = "Kawabata 1980 (shear angle of KES-F)",
                      .read = ReadCloth([](const ClothStrain& cloth, const Vec2&) {
                        return trellis_shear(cloth.shape);
                      }),
                      .in_unit = in_degrees,
                      .metrics = {{"shear_angle_deg", "trellis shear of the cloth under the sensor",
                                   OverFootprint::mean, OverStates::reference}}}},
          .by_default = true,
          .needs_material = true};
}

}  // namespace loosefit::maps

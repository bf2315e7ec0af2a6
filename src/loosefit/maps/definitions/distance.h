#pragma once
#include "loosefit/maps/map_definition.h"

namespace loosefit::maps {

/// From the cloth's middle surface to the body (BodyPartner).
inline MapDefinition distance_map() {
  constexpr double kRange = 40;  // [mm]
  return {
      .name = "distance",
      .arrays = {{.style = {.array = "distance_mm",
                            .title = "Body-garment distance",
                            .unit = "mm",
                            .range_high = kRange,
                            .map = "distance"},
                  .meaning =
                      "From the cloth's middle surface, smooth as it is and not in flat triangles, to "
                      "the nearest point of the body surface on "
                      "the same or a neighbouring limb that faces the same way. Cloth that lies "
                      "on the skin reads half the fabric's thickness.",
                  .formula = "|x − p| + bulge − lift, p the partner on the body (maps/curved_cloth.h)",
                  .source = "Harms, Amft and Tröster 2012, section 2.2",
                  .read = ReadOverSkin(
                      [](const ClothOverSkin& at) { return at.distance; }),
                  .in_unit = millimetres},
                 {.style = {.array = "distance_particle_mm",
                            .title = "Distance to nearest body particle",
                            .unit = "mm",
                            .range_high = kRange,
                            .map = "distance-particle",
                            .pictured = false,
                            .companion = true},
                  .meaning =
                      "The paper's form, to the nearest vertex of the body: never below the other, "
                      "and higher the coarser the body mesh is.",
                  .formula = "|x − x_j|, x_j the nearest body vertex",
                  .source = "Harms, Amft and Tröster 2012, section 2.2",
                  .read = ReadOverSkin(
                      [](const ClothOverSkin& at) { return at.partner.particle_distance; }),
                  .in_unit = millimetres}},
      .by_default = true};
}

}  // namespace loosefit::maps

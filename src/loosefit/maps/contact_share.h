#pragma once
#include <vector>

#include "loosefit/body/posed_body.h"
#include "loosefit/fabric/material.h"
#include "loosefit/maps/pressure.h"

namespace loosefit::maps {

/// Of the area that bears a contact force, what reads as contact: a gap to the skin within the
/// contact tolerance (maps/gap.h). NaN where nothing bears any force.
struct ContactShare {
  /// Gaps of a lattice of places on the flat triangles, as under a sensor's footprint [–]. On a
  /// convex body corners stand off by the height of the chord, h²κ/8.
  double of_places = 0;
  /// Triangles that touch somewhere [–]: the smooth cloth that a flat triangle stands for lies
  /// everywhere as near as the triangle's nearest place (as in maps/pressure.h).
  double of_triangles = 0;
};

/// A third of each triangle belongs to each of its corners, and bears when that vertex is pressed.
ContactShare contact_share_of_pressed_area(const std::vector<Triangle>& triangles,
                                           const std::vector<Vec3>& positions,
                                           const PressureField& pressure,
                                           const body::PosedBody& body,
                                           const fabric::Material& material);

}  // namespace loosefit::maps

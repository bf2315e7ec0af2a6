#pragma once
#include <vector>

#include "loosefit/body/posed_body.h"
#include "loosefit/fabric/material.h"
#include "loosefit/maps/pressure.h"

namespace loosefit::maps {

/// Share of the area that bears a contact force where the gap to the skin is within the contact
/// tolerance (maps/gap.h) [–]; NaN where nothing bears any. A third of each triangle belongs to
/// each of its corners, and bears when that vertex is pressed; gaps are asked on a lattice over the
/// flat triangles, as under a sensor's footprint, since on a convex body the vertices themselves
/// stand off by the height of the chord h²κ/8.
double contact_share_of_pressed_area(const std::vector<Triangle>& triangles,
                                     const std::vector<Vec3>& positions,
                                     const PressureField& pressure, const body::PosedBody& body,
                                     const fabric::Material& material);

}  // namespace loosefit::maps

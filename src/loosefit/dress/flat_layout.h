#pragma once
#include <map>
#include <vector>

#include "loosefit/garment/garment.h"

namespace loosefit::dress {

/// Lays the triangles of one panel into the plane with given places of its outline vertices:
/// every inner vertex at the average of its neighbours (Tutte 1963; Floater 1997), so convex
/// outlines give a map without fold-overs. Returns garment-vertex → place for all panel vertices.
/// \throws GeometryError if an outline vertex has no place.
std::map<int, Vec2> lay_flat(const garment::Garment& garment, int panel,
                             const std::map<int, Vec2>& outline);

/// Number of triangles of the panel that are turned over or flat in this layout; `sign` is +1 when
/// the panel should run counter-clockwise in the plane, −1 for clockwise.
int count_turned_over(const garment::Garment& garment, int panel, const std::map<int, Vec2>& layout,
                      int sign);

}  // namespace loosefit::dress

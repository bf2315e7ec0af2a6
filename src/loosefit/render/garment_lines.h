#pragma once
#include <array>
#include <vector>

#include "loosefit/garment/garment.h"

namespace loosefit::render {

/// Mesh edges to be drawn on a garment.
struct GarmentLines {
  std::vector<std::array<int, 2>> boundary;  ///< one triangle: hem, cuffs, neck
  std::vector<std::array<int, 2>> seams;  ///< the two triangles disagree about the pattern position
};

/// Sorted by vertex index, so equal garments give equal pictures.
GarmentLines garment_lines(const garment::Garment& garment);

}  // namespace loosefit::render

#pragma once
#include <vector>

#include "loosefit/fabric/material.h"
#include "loosefit/garment/garment.h"
#include "loosefit/pattern/panel_mesh.h"

namespace loosefit::garment {

/// Longest over shortest side of a seam that is still sewn, as a gather.
inline constexpr double kGatherLimit = 4.0;

/// Panel meshes of one level sewn together.
struct SewnPanels {
  Garment garment;
  std::vector<std::vector<int>> vertex_of;  ///< [panel][panel vertex] → garment vertex
};

/// Welds the seams of meshed panels: paired vertices become one. Orientation is that of the
/// outlines (normal = outside); a panel behind a right_wrong seam is turned over. Masses are a
/// third of the flat triangle area each, more where pieces and hems are thicker (thicken.h).
/// Vertices of `coarser` (numbering of the coarser level, or nullptr) keep their numbers, new ones
/// follow. \throws GeometryError when a seam cannot close: gather beyond kGatherLimit, a triangle
/// or edge
///         that collapses, more than two triangles at an edge, sheets that touch in a point only, a
///         one-sided (Möbius) surface.
SewnPanels sew_panels(const pattern::Pattern& pattern,
                      const std::vector<pattern::PanelMesh>& meshes,
                      const fabric::Material& material,
                      const std::vector<std::vector<int>>* coarser = nullptr);

}  // namespace loosefit::garment

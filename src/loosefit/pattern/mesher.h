#pragma once
#include <vector>

#include "loosefit/pattern/inset_lines.h"
#include "loosefit/pattern/panel_mesh.h"

namespace loosefit::pattern {

/// Irregular triangle mesh of a panel whose edge e is divided into divisions[e] segments:
/// constrained Delaunay triangulation refined at circumcentres (Chew 1989; Shewchuk 2000), but
/// never on the outline, so seams stay matched. Interior points are then moved to the centroids of
/// their surroundings, which brings triangles close to equilateral. Parts of an inset that come
/// near the rim of the cloth or an earlier inset are no edges of the mesh. \throws GeometryError
/// when the panel cannot be meshed.
PanelMesh mesh_panel(const Panel& panel, const std::vector<int>& divisions, double edge_length,
                     const std::vector<MeshInset>& insets = {});

}  // namespace loosefit::pattern

#pragma once
#include <array>
#include <vector>

#include "loosefit/pattern/pattern.h"

namespace loosefit::pattern {

/// Vertices round a hole of a panel.
struct MeshedRim {
  std::vector<int> vertices;  ///< counter-clockwise, the first one once
  std::vector<double> along;  ///< their places along PanelHole::points [m], rising
};

/// Flat triangle mesh of one panel.
struct PanelMesh {
  std::vector<Vec2> vertices;       ///< [m]; the outline comes first, in order, then the holes
  std::vector<Triangle> triangles;  ///< counter-clockwise; neighbours mostly near in the list
  /// Per panel edge: vertices along it, ends included, even in arc length.
  std::vector<std::vector<int>> edge_vertices;
  std::vector<MeshedRim> holes;  ///< per hole of the panel
};

/// Smallest interior angle of a triangle [rad].
double smallest_angle(const Vec2& a, const Vec2& b, const Vec2& c);

/// Shape of a mesh in numbers.
struct MeshQuality {
  double smallest_angle = kPi;  ///< over all triangles [rad]
  double mean_angle = 0;        ///< mean over triangles of their smallest angle [rad]; 60° at best
  double mean_edge = 0;         ///< [m]
};
MeshQuality mesh_quality(const PanelMesh& mesh);

/// Every triangle split into four. Midpoints on an edge of the panel or on the rim of a hole are
/// moved onto its curve at the middle of their arc. `parents[i]` are the two coarse vertices vertex
/// i lies between, equal for a kept one; the coarse vertices keep their numbers.
PanelMesh subdivide(const PanelMesh& coarse, const Panel& panel,
                    std::vector<std::array<int, 2>>& parents);

}  // namespace loosefit::pattern

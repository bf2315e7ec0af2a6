#pragma once
#include <vector>

#include "loosefit/garment/garment.h"
#include "loosefit/geometry/flat_triangle.h"

namespace loosefit::maps {

/// F of one garment triangle, from pattern (u, v) to space: dx = F du. Columns are the images of
/// weft and warp. NaN for a triangle without flat area.
geometry::DeformationGradient garment_gradient(const garment::Garment& garment, int triangle,
                                               const std::vector<Vec3>& positions);

/// Strain of one garment triangle. F is the 3×2 deformation gradient from pattern coordinates (u
/// weft, v warp) to space, dx = F du; the stretch along a unit pattern direction d is |F d| and
/// every strain here is the engineering one, stretch − 1 [–].
struct TriangleStrain {
  double weft = 0;  ///< |F u| − 1
  double warp = 0;  ///< |F v| − 1
  double max = 0;   ///< greatest principal stretch − 1 (larger singular value of F)
  double min = 0;   ///< least principal stretch − 1; below zero the cloth is shortened or buckled
};

/// From the deformation gradient; NaN for that of a triangle without flat area.
TriangleStrain triangle_strain(const geometry::DeformationGradient& f);
TriangleStrain triangle_strain(const garment::Garment& garment, int triangle,
                               const std::vector<Vec3>& positions);
/// The same of every triangle.
std::vector<TriangleStrain> triangle_strains(const garment::Garment& garment,
                                             const std::vector<Vec3>& positions);

/// Strain |F d| − 1 along the unit direction d = (weft, warp) of the pattern, the reading of a
/// strain sensor that is sewn on along d (docs/theory/sensor_metrics.md 6). NaN without flat area.
double strain_along(const geometry::DeformationGradient& f, const Vec2& direction);

/// Cloth whose least principal strain is below this is slack: buckled within an element, so that no
/// strain sensor reads it (docs/theory/sensor_metrics.md 6).
inline constexpr double kSlackStrain = -0.005;
/// 1 for slack cloth, 0 for other; NaN without flat area.
double slack_of(const TriangleStrain& strain);

/// Mean of a triangle quantity at each vertex, weighted by flat triangle area; NaN where no
/// triangle with a value touches the vertex.
std::vector<double> to_vertices(const garment::Garment& garment,
                                const std::vector<double>& per_triangle);

/// Elongation of the garment edges along the grain, the paper's "vertical strain": initial and
/// actual distances between neighbouring particles are compared,
///
///   ε_ij = (|x_j − x_i| − L_ij) / L_ij,   ε_i = Σ_j w_ij ε_ij / Σ_j w_ij,   w_ij = cos²(edge,
///   grain)
///
/// L_ij is the distance in the flat pattern. "Vertical" is the grain (warp), which hangs vertically
/// in a worn torso and runs along the arm in a sleeve; so the value belongs to a place in the
/// garment whatever the posture. Edges that lie on a seam are left out: they have two rest lengths.
/// A vertex without another edge gets NaN. (Harms, Amft, Tröster 2012, section 2.2.) `warp` above
/// is the same quantity free of the mesh's edge directions.
std::vector<double> vertical_strain(const garment::Garment& garment,
                                    const std::vector<Vec3>& positions);

/// Lumped flat area of each vertex: a third of its triangles [m²]. The weights of all statistics.
std::vector<double> vertex_areas(const garment::Garment& garment);

}  // namespace loosefit::maps

#pragma once
#include <vector>

#include "loosefit/body/posed_body.h"
#include "loosefit/garment/garment.h"

namespace loosefit::maps {

/// The smooth cloth for which a flat triangle stands (docs/theory/sensor_metrics.md 4).
///
/// Between two corners it bulges out of the chord by L² κ/8, L the edge and κ its curvature by the
/// vertex normals (Vlachos et al. 2001, PN triangles, to second order). Where it hangs free the
/// mesh keeps lengths, so its corners stand out by a third of that. On the skin the flat triangle
/// rests on its middle and its corners stand off by all of it, though the smooth cloth lies as near
/// as the triangle's nearest place. In between the share goes over evenly.
struct CurvedTriangle {
  Vec3 bulge = Vec3::Zero();  ///< at the middle of the edge from corner k to k + 1 [m]
  double lift = 0;            ///< how far out the corners stand of the smooth cloth [m]
};

/// One per triangle. `normals`: unit, per vertex; `distances`: of the vertices to the skin [m].
std::vector<CurvedTriangle> curved_triangles(const garment::Garment& garment,
                                             const std::vector<Vec3>& positions,
                                             const std::vector<Vec3>& normals,
                                             const std::vector<double>& distances,
                                             const body::PosedBody& body);

/// Distance of the smooth cloth from the skin [m] at a place of a triangle whose flat place is
/// `distance` away; not below zero.
double smooth_distance(const CurvedTriangle& triangle, const Vec3& barycentric, double distance);

/// The same at the vertices: mean over their triangles by flat area.
std::vector<double> smooth_vertex_distances(const garment::Garment& garment,
                                            const std::vector<CurvedTriangle>& triangles,
                                            const std::vector<double>& distances);

}  // namespace loosefit::maps

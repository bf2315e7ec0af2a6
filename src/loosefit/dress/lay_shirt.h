#pragma once
#include "loosefit/dress/dress.h"
#include "loosefit/geometry/triangle_mesh.h"

namespace loosefit {

/// A shirt laid round a body, and how far from it.
struct ShirtStart {
  std::vector<Vec3> positions;
  double clearance = 0;  ///< [m]
};

/// As dress_shirt, over what is worn under it: with this clearance or more until nothing cuts.
/// `layer`: number of garments under it. \throws GeometryError as dress_shirt.
ShirtStart lay_shirt(const Garment& shirt, const Body& body, double first_clearance, int layer,
                     const TriangleMesh& under);

}  // namespace loosefit

#pragma once
#include <vector>

#include "loosefit/geometry/triangle_mesh.h"

namespace loosefit::geometry {

/// Vectors at a surface's vertices without their short waves: 1 − (1 − S)³ of them, with S two
/// implicit steps of diffusion on the surface (Desbrun et al. 1999), of spread² / 2 each; the
/// spread [m] is given per vertex, and vertices without (0) keep what they have. Given the places,
/// it takes details away but hardly shrinks what is round, as the filter of Taubin (1995) does: a
/// wave of length l keeps 1 − (1 − (1 + ½ k² spread²)⁻²)³ of its height, k = 2π / l, which is a
/// half at 4 spreads.
std::vector<Vec3> low_passed(std::vector<Vec3> values, const TriangleMesh& mesh,
                             const std::vector<double>& spreads);

}  // namespace loosefit::geometry

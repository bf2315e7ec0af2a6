#pragma once
#include <vector>

#include "loosefit/base/types.h"

namespace loosefit::fabric {

/// Curvature of a triangulated sheet from its dihedral angles, triangle by triangle.
///
/// 1. Each triangle with its three neighbours, unfolded into the flat pattern, carries the
/// quadratic
///    height function that meets all six corners (triangle-centred fit). The height of a
///    neighbour's free corner is h θ (h its flat height over the shared edge, θ the dihedral
///    angle), so that a sheet rolled to a cylinder has exactly the curvature of the circle.
/// 2. The slopes of the two fits at the middle of a shared edge are averaged, and the curvature of
///    a triangle is the contour integral of these slopes, κ = 1/A Σ l s n⊗n.
///
/// Linear in the angles:  (κ_uu, κ_vv, 2κ_uv)ᵀ = S θ  with θ the own angles and those of the
/// neighbours' other edges. Step 1 is exact for every constant curvature on every mesh, so any
/// Poisson ratio in bending can be represented (a plain hinge energy acts as ν = −1/3,
/// docs/theory/validation.md 2.1). Step 2 makes the slope single-valued, so that a constant moment
/// is in balance at every inner vertex of every mesh; without it strips come out 1 to 3 % too soft
/// however fine the mesh. Source: Reisman, Grinspun and Zorin 2007 (step 1); Oñate and Flores 2005
/// (EBST: patch and averaged side slopes as a shell element).
struct CurvaturePatch {
  /// The three own hinges (opposite corner k; −1: a free border), then those of the neighbours.
  std::array<int, 9> hinge{-1, -1, -1, -1, -1, -1, -1, -1, -1};
  int hinges = 3;                                                       ///< used of these
  Eigen::Matrix<double, 3, 9> s = Eigen::Matrix<double, 3, 9>::Zero();  ///< S [1/m per rad]
  Mat3 fit = Mat3::Zero();  ///< step 1 alone: κ from the own angles [1/m per rad]
  double area = 0;          ///< flat [m²]
  /// Corners, free corners of the neighbours, then the rest.
  std::array<int, 12> particle{};
  int count = 3;                             ///< of particles
  std::array<std::array<int, 4>, 9> slot{};  ///< places in `particle` of the points of each hinge
};

/// All hinges and patches of a garment.
struct CurvaturePatches {
  /// Edge x0 x1, opposite corner x2 of triangle (x0, x1, x2), and x3 of triangle (x1, x0, x3).
  std::vector<std::array<int, 4>> hinges;
  std::vector<CurvaturePatch> patches;  ///< one per triangle
};

/// `rigidity[t]` (3 × 3, for κ_uu, κ_vv, 2κ_uv) enters at free borders only: the unknown angle
/// there is the one for which the border carries no moment; in corners with two borders, and where
/// the patch says little about that moment, the one of least energy.
/// `built_in[t]` (may be empty) marks triangles held in a rigid clamp: they store nothing, and
/// their neighbours bend as if mirrored in the clamp line, which is the condition w' = 0 there.
/// \throws GeometryError for a pattern triangle without area.
CurvaturePatches curvature_patches(const std::vector<Triangle>& triangles,
                                   const std::vector<std::array<Vec2, 3>>& triangle_uv,
                                   const std::vector<Mat3>& rigidity,
                                   const std::vector<char>& built_in = {});

}  // namespace loosefit::fabric

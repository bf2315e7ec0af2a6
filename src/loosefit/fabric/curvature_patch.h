#pragma once
#include <vector>

#include "loosefit/base/types.h"

namespace loosefit {

/// Curvature of a triangulated sheet from its dihedral angles, triangle by triangle.
///
/// Each triangle with its three neighbours, unfolded into the flat pattern, carries the quadratic
/// height function that meets all six corners; its second derivatives are the curvature tensor.
/// The height of a neighbour's free corner is h θ (h its flat height over the shared edge, θ the
/// dihedral angle), so that a sheet rolled to a cylinder has exactly the curvature of the circle.
/// Linear in the three angles:  (κ_uu, κ_vv, 2κ_uv)ᵀ = S (θ₀, θ₁, θ₂)ᵀ.  Exact for every constant
/// curvature on every mesh, so any Poisson ratio in bending can be represented (a plain hinge
/// energy acts as ν = −1/3, validation.md 2.3).
/// Source: Reisman, Grinspun and Zorin 2007 (triangle-centred quadratic interpolation of the shape
/// operator); Oñate and Flores 2005 (EBST: the same patch as a shell element).
struct CurvaturePatch {
  std::array<int, 3> hinge{-1, -1, -1};      ///< opposite corner k; −1: the edge is a free border
  Mat3 s = Mat3::Zero();                     ///< S [1/m per rad]; zero columns at borders
  double area = 0;                           ///< flat [m²]
  std::array<int, 6> particle{};             ///< corners, then the free corners of the neighbours
  int count = 3;                             ///< of particles
  std::array<std::array<int, 4>, 3> slot{};  ///< places in `particle` of the points of each hinge
};

/// All hinges and patches of a garment.
struct CurvaturePatches {
  /// Edge x0 x1, opposite corner x2 of triangle (x0, x1, x2), and x3 of triangle (x1, x0, x3).
  std::vector<std::array<int, 4>> hinges;
  std::vector<CurvaturePatch> patches;  ///< one per triangle
};

/// `rigidity[t]` (3 × 3, for κ_uu, κ_vv, 2κ_uv) enters at free borders only: the unknown angle
/// there is the one of least energy, which is the natural condition of a moment-free border.
/// `built_in[t]` (may be empty) marks triangles held in a rigid clamp: they store nothing, and
/// their neighbours bend as if mirrored in the clamp line, which is the condition w' = 0 there.
/// \throws GeometryError for a pattern triangle without area.
CurvaturePatches curvature_patches(const std::vector<Triangle>& triangles,
                                   const std::vector<std::array<Vec2, 3>>& triangle_uv,
                                   const std::vector<Mat3>& rigidity,
                                   const std::vector<char>& built_in = {});

}  // namespace loosefit

#pragma once
#include "loosefit/fabric/plane_law.h"
#include "loosefit/fabric/stress_curve.h"

namespace loosefit::fabric {

/// Yarns that buckle in waves finer than the mesh
/// (docs/decisions/0017-cloth-that-buckles-below-the-mesh.md).
///
/// Compressed cloth buckles in waves of millimetres and then carries next to nothing; a flat
/// triangle of a coarse mesh cannot. Crimp c ≥ 0 is the part of the Green strain that a wave below
/// the mesh takes up, the yarn bears e = ε + c:
///
///   w(ε) = min over c_u, c_v ≥ 0 of  w_el(ε_uu + c_u, ε_vv + c_v) + Σ_i σ_i (c_i + 3/4 c_i²)
///   σ = 4π² B/h²     Euler's load of a wave one edge long [N/m]
///   w_el = w_u(e_u) + w_v(e_v) + C_uv e_u e_v
///
/// B bending rigidity of the direction [N m], h = 2 √(A/√3) the edge of an equilateral triangle of
/// flat area A [m]. 3/2 is the slope of the elastica: its force rises by Δ/2 with the shortening Δ,
/// the stress S = force/λ by 3Δ/2, to the first order. As a minimum of a jointly convex function w
/// is convex and C¹ wherever w_el is convex. In tension it is w_el. Crimp vanishes with h. Sources:
/// Choi and Ko 2002; Chen et al. 2021; tension field theory (Steigmann 1990).
struct CrimpLaw {
  static constexpr double kEuler = 39.478417604357434;  ///< 4π²
  static constexpr double kRise = 1.5;                  ///< d(σ/σ_c)/dc of the elastica

  /// Euler's load [N/m] of a wave one edge long in cloth of rigidity B [N m] and flat area A [m²].
  static double euler_load(double rigidity, double area);

  StressCurve u, v;                   ///< w_u of the weft, w_v of the warp
  double coupling = 0;                ///< C_uv [N/m]
  bool is_linear = true;              ///< neither direction has a measured curve
  double linear_u = 0, linear_v = 0;  ///< C_uu, C_vv where both are linear [N/m]

  struct Rows {
    particles::TileRow energy;                 ///< [J/m²]
    std::array<particles::TileRow, 2> stress;  ///< S_uu, S_vv [N/m]
    std::array<particles::TileRow, 2> crimp;   ///< c_u, c_v [–]
  };
  /// Of a tile of triangles with Euler loads `load` (u, v). `tangent`: the rows C_uu, C_vv, C_uv of
  /// the second derivative, which jumps where a yarn buckles; null: not wanted.
  void respond(const PlaneRows& strain, const std::array<particles::TileRow, 2>& load, Rows& out,
               PlaneTangent* tangent) const;
};

}  // namespace loosefit::fabric

#pragma once
#include <algorithm>
#include <string>
#include <vector>

namespace loosefit::fabric {

/// One point of a measured force-strain law; the origin is always part of the law.
struct CurvePoint {
  double strain = 0;  ///< tension: elongation λ − 1 [–]; shear: γ = U·V [–]
  double force = 0;   ///< tension: force per metre of reference width; shear: stress S_uv [N/m]
};

/// Measured or published constants of one fabric, SI (docs/theory/materials.md 7).
struct Material {
  std::string name;
  std::string source;            ///< where the numbers come from
  double areal_density = 0.12;   ///< w, areal density [kg/m²]
  double thickness = 0.0005;     ///< [m]; half of it is the contact offset
  double stiffness_warp = 2000;  ///< K_v, membrane [N/m]; with a curve: its initial slope
  double stiffness_weft = 2000;  ///< K_u [N/m]
  double poisson = 0.15;         ///< ν of the membrane (geometric mean of ν_uv, ν_vu) [–]
  double stiffness_shear = 40;   ///< G, against trellis shear [N/m per rad]
  /// Measured laws that replace the stiffness of their direction (stress_curve.h); empty: linear.
  std::vector<CurvePoint> curve_warp, curve_weft, curve_shear;
  double bending_warp = 4.41e-6;  ///< B_v [N m]
  double bending_weft = 4.41e-6;  ///< B_u [N m]
  /// ν_b of bending [–]: D_12 = ν_b √(D_u D_v), D_66 = (1 − ν_b) √(D_u D_v)/2, D = B.
  double bending_poisson = 0;
  double bending_hysteresis_warp = 0;  ///< HB_v [N]: half of the KES loop width 2HB; 0 = elastic
  double bending_hysteresis_weft = 0;  ///< HB_u [N]
  double friction_body = 0.4;          ///< Coulomb, fabric on skin [–]
  double friction_self = 0.4;          ///< fabric on fabric [–]
  double damping = 0.02;               ///< stiffness-proportional damping time [s]; dynamics only
  /// Largest elongation λ − 1 [–] and shear angle [rad] up to which the constants and curves of the
  /// plane stand for what was measured; beyond, they are extrapolated. 0: not stated.
  double valid_strain_warp = 0, valid_strain_weft = 0, valid_shear = 0;
  /// Elongation λ − 1 to which a hand pulls the cloth and it comes back [–]: the stretch of a knit
  /// as drafting states it. The constants may stand for less. 0: not stated.
  double stretch_warp = 0, stretch_weft = 0;

  /// Elongation up to which the cloth is known to give [–]; 0: nothing is stated.
  double gives_warp() const { return std::max(valid_strain_warp, stretch_warp); }
  double gives_weft() const { return std::max(valid_strain_weft, stretch_weft); }
};

/// Multiplies everything that resists in the plane, curves included, by `share`.
inline void scale_membrane(Material& material, double share) {
  material.stiffness_warp *= share;
  material.stiffness_weft *= share;
  material.stiffness_shear *= share;
  for (auto* curve : {&material.curve_warp, &material.curve_weft, &material.curve_shear})
    for (CurvePoint& point : *curve) point.force *= share;
}

}  // namespace loosefit::fabric

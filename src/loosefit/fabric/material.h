#pragma once
#include <string>

namespace loosefit {

/// Measured or published constants of one fabric, SI (materials.md section 7).
struct Material {
  std::string name;
  std::string source;             ///< where the numbers come from
  double areal_density = 0.12;    ///< w [kg/m²]
  double thickness = 0.0005;      ///< [m]; half of it is the contact offset
  double stiffness_warp = 2000;   ///< K_v, membrane [N/m]
  double stiffness_weft = 2000;   ///< K_u [N/m]
  double poisson = 0.15;          ///< ν of the membrane (geometric mean of ν_uv, ν_vu) [–]
  double stiffness_shear = 40;    ///< G [N/m per rad]
  double compression_factor = 1;  ///< option: stiffness ratio in compression, (0, 1]
  double bending_warp = 4.41e-6;  ///< B_v [N m]
  double bending_weft = 4.41e-6;  ///< B_u [N m]
  /// ν_b of bending [–]: D_12 = ν_b √(D_u D_v), D_66 = (1 − ν_b) √(D_u D_v)/2, D = B.
  double bending_poisson = 0;
  double bending_hysteresis_warp = 0;  ///< HB_v [N]: half of the KES loop width 2HB; 0 = elastic
  double bending_hysteresis_weft = 0;  ///< HB_u [N]
  double friction_body = 0.4;     ///< Coulomb, fabric on skin [–]
  double friction_self = 0.4;     ///< fabric on fabric [–]
  double damping = 0.02;          ///< stiffness-proportional damping time [s]; dynamics only
};

}  // namespace loosefit

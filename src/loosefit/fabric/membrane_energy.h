#pragma once
#include <vector>

#include "loosefit/fabric/material.h"
#include "loosefit/particles/energy.h"

namespace loosefit {

/// In-plane elasticity of a sewn garment: orthotropic St. Venant-Kirchhoff on each triangle.
///
///   U = Σ r_ui x_i, V = Σ r_vi x_i          images of the unit weft and warp vectors [–]
///   ε_uu = (U·U − 1)/2, ε_vv = (V·V − 1)/2, γ = U·V                 Green-Lagrange [–]
///   W = A [ ½ C_uu ε_uu² + C_uv ε_uu ε_vv + ½ C_vv ε_vv² + ½ G γ² ]                 [J]
///   C_uu = K_u/(1−ν²), C_vv = K_v/(1−ν²), C_uv = ν √(K_u K_v)/(1−ν²)               [N/m]
///
/// A flat area [m²], K membrane stiffness [N/m], G [N/m]. With compression_factor c < 1 the tensile
/// stiffness of a compressed direction is c times smaller (C¹ energy, coupling scaled by √(c_u
/// c_v)). Strain-rate viscosity with damping time τ is the incremental potential of the stress τ C
/// ε̇, ε̇ ≈ (ε − ε_start)/dt: it vanishes for rigid motion and in statics. Source: Volino and
/// Magnenat-Thalmann 2005; Volino, Magnenat-Thalmann and Faure 2009.
class MembraneEnergy : public Energy {
 public:
  /// triangle_uv: flat corners (u weft, v warp) [m]; factor: stiffness multiplier per triangle.
  MembraneEnergy(const std::vector<Triangle>& triangles,
                 const std::vector<std::array<Vec2, 3>>& triangle_uv,
                 const std::vector<double>& factor, const Material& material, bool viscous = false);

  void begin_step(const VectorField& x, double dt) override;
  double value(const VectorField& x) const override;
  void add_gradient(const VectorField& x, VectorField& g) const override;
  void add_pattern(const VectorField& x, BlockPattern& pattern) const override;
  void add_hessian(const VectorField& x, BlockMatrix& h, HessianKind kind) const override;

  /// Green strain (ε_uu, ε_vv, γ) and second Piola-Kirchhoff stress (s_uu, s_vv, s_uv) [N/m].
  struct State {
    Vec3 strain, stress;
  };
  State state(int triangle, const VectorField& x) const;

 private:
  struct Element {
    Triangle t;
    std::array<double, 3> ru, rv;  ///< gradients of the shape functions [1/m]
    double area;                   ///< [m²]
    double factor;
  };
  struct Kinematics {
    Vec3 u, v, strain;
  };
  Kinematics kinematics(const Element& e, const VectorField& x) const;
  Mat3 tangent(const Element& e, const Vec3& strain) const;
  Mat3 elastic(const Element& e, const Vec3& strain) const;

  std::vector<Element> elements_;
  double c_uu_, c_vv_, c_uv_, g_, compression_;
  double damping_ = 0;        ///< τ [s]
  double viscous_ratio_ = 0;  ///< τ/dt of the current step
  std::vector<Vec3> strain_start_;
};

}  // namespace loosefit

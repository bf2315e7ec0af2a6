#pragma once
#include <vector>

#include "loosefit/fabric/material.h"
#include "loosefit/particles/energy.h"

namespace loosefit {

/// Dihedral angle θ [rad] of the hinge (edge x0 x1, opposite corners x2 of triangle (x0, x1, x2)
/// and x3 of triangle (x1, x0, x3)); 0 when flat. Gradient and Hessian with respect to the four
/// points. Source: Grinspun et al. 2003; Tamstorf and Grinspun 2013, derived anew for this sign
/// convention.
struct Dihedral {
  double angle = 0;
  std::array<Vec3, 4> gradient;
  std::array<std::array<Mat3, 4>, 4> hessian;  ///< filled only on request
};
Dihedral dihedral(const Vec3& x0, const Vec3& x1, const Vec3& x2, const Vec3& x3,
                  bool with_hessian);

/// Bending of a sewn garment by the calibrated hinge energy (validation.md 2.2)
///
///   W_e = ½ B l² θ² / (A₁ + A₂)                                            [J]
///
/// l flat edge length [m], A flat areas [m²], B rigidity [N m] of the direction across the edge,
/// B = B_u cos⁴φ + B_v sin⁴φ + 2 √(B_u B_v) cos²φ sin²φ (φ from the weft; isotropic if B_u = B_v),
/// plus what attachments add. Exact for cylinders on near-equilateral meshes; acts like a Kirchhoff
/// plate with ν = −1/3. Rest angle 0, seams included. Viscosity as in MembraneEnergy.
class BendingEnergy : public Energy {
 public:
  BendingEnergy(const std::vector<Triangle>& triangles,
                const std::vector<std::array<Vec2, 3>>& triangle_uv,
                const std::vector<double>& added_rigidity, const Material& material,
                bool viscous = false);

  void begin_step(const VectorField& x, double dt) override;
  double value(const VectorField& x) const override;
  void add_gradient(const VectorField& x, VectorField& g) const override;
  void add_pattern(const VectorField& x, BlockPattern& pattern) const override;
  void add_hessian(const VectorField& x, BlockMatrix& h, HessianKind kind) const override;

 private:
  struct Hinge {
    std::array<int, 4> v;
    double stiffness;  ///< B l²/(A₁+A₂) [N m]
  };
  std::vector<Hinge> hinges_;
  double damping_ = 0;
  double viscous_ratio_ = 0;
  std::vector<double> angle_start_;
};

}  // namespace loosefit

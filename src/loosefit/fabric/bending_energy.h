#pragma once
#include <vector>

#include "loosefit/fabric/bending_friction.h"
#include "loosefit/fabric/curvature_patch.h"
#include "loosefit/fabric/dihedral.h"
#include "loosefit/fabric/material.h"
#include "loosefit/particles/energy.h"

namespace loosefit {

/// Rigidity of an orthotropic plate for (κ_uu, κ_vv, 2κ_uv) [N m]: D_u = B_u, D_v = B_v,
/// D_12 = ν_b √(D_u D_v), D_66 = (1 − ν_b) √(D_u D_v)/2 (materials.md 7), plus an isotropic sheet
/// of rigidity `added` and the same ν_b. B is the rigidity of a wide sheet; a narrow strip, free to
/// contract sideways, bends with B (1 − ν_b²).
Mat3 plate_rigidity(const Material& material, double added = 0);

/// Bending of a sewn garment: an orthotropic Kirchhoff plate on curvature patches,
///
///   W = Σ A [ ½ κᵀ D κ + w_friction(κ) ],   κ = S θ                                [J]
///
/// with θ the dihedral angles round a triangle (CurvaturePatch), D of plate_rigidity plus what
/// attachments add, and the inner friction of BendingFriction. Rest angle 0, seams included.
/// Viscosity as in MembraneEnergy: the stress τ D κ̇.
/// The near tangent, and the definite one, give each hinge a stiffness of its own (the diagonal of
/// the fit with a triangle's own angles, CurvaturePatch step 1): four particles a hinge instead of
/// twelve a triangle.
/// The memory of the inner friction starts from flat cloth: what is bent at first has been bent
/// there in one go.
class BendingEnergy : public Energy {
 public:
  BendingEnergy(const std::vector<Triangle>& triangles,
                const std::vector<std::array<Vec2, 3>>& triangle_uv,
                const std::vector<double>& added_rigidity, const Material& material,
                bool viscous = false, const std::vector<char>& built_in = {});

  /// Curvature (κ_uu, κ_vv, 2κ_uv) of a triangle [1/m], positive where the outside is convex.
  Vec3 curvature(int triangle, const VectorField& x) const;

  void set_tangent(TangentReach reach) override { tangent_ = reach; }
  void begin_step(const VectorField& x, double dt) override;
  double value(const VectorField& x) const override;
  void add_gradient(const VectorField& x, VectorField& g) const override;
  void add_pattern(const VectorField& x, BlockPattern& pattern) const override;
  void add_hessian(const VectorField& x, BlockMatrix& h, HessianKind kind) const override;

 private:
  using Vector9 = Eigen::Matrix<double, 9, 1>;
  using Matrix9 = Eigen::Matrix<double, 9, 9>;
  std::vector<double> angles(const VectorField& x) const;
  Vector9 of_patch(std::size_t patch, const std::vector<double>& angle) const;
  Vector9 moments(std::size_t patch, const Vector9& angle) const;
  Matrix9 tangent(std::size_t patch, const Vector9& angle) const;
  std::vector<double> hinge_stiffness(const std::vector<double>& angle) const;
  void add_patches(const std::vector<Dihedral>& hinge, const std::vector<double>& angle,
                   BlockMatrix& h) const;
  std::vector<double> hinge_moments(const std::vector<double>& angle) const;

  CurvaturePatches mesh_;
  std::vector<Matrix9> stiffness_;       ///< A Sᵀ D S per patch [N m]
  std::vector<double> hinge_stiffness_;  ///< of the near tangent [N m]
  BendingFriction friction_;
  TangentReach tangent_ = TangentReach::full;
  std::vector<Vec3> anchor_;          ///< z₀ of the inner friction, per patch
  double damping_ = 0;                ///< τ [s]
  double viscous_ratio_ = 0;          ///< τ/dt of the current step
  std::vector<Vector9> angle_start_;  ///< per patch [rad]
};

}  // namespace loosefit

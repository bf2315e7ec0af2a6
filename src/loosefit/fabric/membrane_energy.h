#pragma once
#include <memory>
#include <vector>

#include "loosefit/fabric/crimp_law.h"
#include "loosefit/fabric/material.h"
#include "loosefit/fabric/membrane_kernel.h"
#include "loosefit/particles/block_gather.h"
#include "loosefit/particles/energy_capabilities.h"
#include "loosefit/particles/particle_gather.h"

namespace loosefit::fabric {

/// In-plane elasticity of a sewn garment on flat triangles: orthotropic yarns that buckle in waves
/// below the mesh (CrimpLaw), and trellis shear.
///
///   U = Σ r_ui x_i, V = Σ r_vi x_i          images of the unit weft and warp vectors [–]
///   ε_uu = (U·U − 1)/2, ε_vv = (V·V − 1)/2, γ = U·V                 Green-Lagrange [–]
///   W = A [ w(ε_uu, ε_vv) + w_s(γ) ]                                                [J]
///
/// A flat area [m²]. In tension and without measured curves this is St. Venant-Kirchhoff:
///
///   w = ½ C_uu ε_uu² + ½ C_vv ε_vv² + C_uv ε_uu ε_vv, w_s = ½ G γ²
///   C_uu = K_u/(1−ν²), C_vv = K_v/(1−ν²), C_uv = ν √(K_u K_v)/(1−ν²)               [N/m]
///
/// K membrane stiffness [N/m], G [N/m]. A measured curve replaces w of its direction
/// (stress_curve.h). It is taken as measured with the width held, as KES-FB1 does: at ε_vv = 0 the
/// weft force is the curve, whatever ν. The coupling stays the constant C_uv = ν √(k_u k_v), k the
/// smallest tangent of w_u and w_v (zero if one is not positive): then an energy exists, it is
/// convex in the strains over the measured range, and a fabric that stiffens contracts relatively
/// less. Shear is not capped: cloth resists it little.
///
/// Strain-rate viscosity with damping time τ is the incremental potential of the stress τ C ε̇,
/// ε̇ ≈ (ε − ε_start)/dt, with C the tangent at the start of the step (without its negative part):
/// it vanishes for rigid motion and in statics. Source: Volino and Magnenat-Thalmann 2005; Volino,
/// Magnenat-Thalmann and Faure 2009.
class MembraneEnergy : public particles::Energy,
                       public particles::LaggedState,
                       public particles::ActiveSetUser {
 public:
  /// triangle_uv: flat corners (u weft, v warp) [m]; factor: stiffness multiplier per triangle;
  /// added_bending: rigidity per triangle that holds buckling up, beside that of the cloth [N m].
  /// Empty: 1 and 0. \throws GeometryError for a flat triangle without area; InvalidInput as
  /// StressCurve.
  MembraneEnergy(const std::vector<Triangle>& triangles,
                 const std::vector<std::array<Vec2, 3>>& triangle_uv,
                 const std::vector<double>& factor, const Material& material, bool viscous = false,
                 const std::vector<double>& added_bending = {});

  void begin_step(const particles::VectorField& x, double dt) override;
  void set_active_set(const particles::ActiveSet* active_set) override;
  double value(const particles::VectorField& x) const override;
  void add_gradient(const particles::VectorField& x, particles::VectorField& g) const override;
  double value_and_gradient(const particles::VectorField& x,
                            particles::VectorField& g) const override;
  void add_pattern(const particles::VectorField& x,
                   particles::BlockPattern& pattern) const override;
  void add_hessian(const particles::VectorField& x, particles::BlockMatrix& h,
                   particles::HessianKind kind) const override;

  /// Green strain (ε_uu, ε_vv, γ), second Piola-Kirchhoff stress (s_uu, s_vv, s_uv) [N/m], and the
  /// crimp (c_u, c_v): the yarns bear ε + c.
  struct State {
    Vec3 strain, stress;
    Vec2 crimp;
  };
  /// Of every triangle.
  std::vector<State> states(const particles::VectorField& x) const;
  State state(int triangle, const particles::VectorField& x) const { return states(x)[triangle]; }

 private:
  /// Strain, stress with viscosity, crimp and tangent of a tile.
  struct TileState {
    MembraneStrain s;
    PlaneResponse response;
    PlaneTangent tangent;
    std::array<particles::TileRow, 2> crimp;
  };
  void tile_state(int tile, const particles::VectorField& x, bool with_tangent,
                  TileState& state) const;
  double evaluate(const particles::VectorField& x, bool forces) const;

  std::size_t count_ = 0;
  std::vector<MembraneTile> tiles_;
  std::vector<std::array<particles::TileRow, 2>> load_;  ///< Euler loads of each triangle [N/m]
  std::vector<double> factor_;
  CrimpLaw yarns_;
  StressCurve shear_;
  double damping_ = 0;        ///< τ [s]
  double viscous_ratio_ = 0;  ///< τ/dt of the current step
  std::vector<PlaneRows> strain_start_;
  std::vector<PlaneTangent> tangent_start_;

  const particles::ActiveSet* active_set_ = nullptr;
  particles::IndexSubset active_tiles_;

  particles::ParticleGather to_particles_;
  particles::BlockGather to_blocks_;
  // Room that is kept from call to call: an energy belongs to one thread at a time.
  mutable std::vector<double> energy_;  ///< per tile
  mutable std::vector<Vec3> force_;     ///< per corner
  mutable std::vector<Mat3> block_;     ///< six per triangle
};

}  // namespace loosefit::fabric

#pragma once
#include <memory>
#include <vector>

#include "loosefit/fabric/material.h"
#include "loosefit/fabric/membrane_kernel.h"
#include "loosefit/fabric/strain_patch.h"
#include "loosefit/fabric/stress_curve.h"
#include "loosefit/particles/block_gather.h"
#include "loosefit/particles/energy_capabilities.h"
#include "loosefit/particles/particle_gather.h"

namespace loosefit::fabric {

/// Share of the energy of stretched yarns that stays on single triangles (MembraneEnergy). Small,
/// as that share locks as before; not zero, as only it and the shear hold down strains that
/// alternate from triangle to triangle and cancel round every vertex.
inline constexpr double kTriangleShare = 0.05;

/// In-plane elasticity of a sewn garment: orthotropic, on each triangle and round each vertex.
///
///   U = Σ r_ui x_i, V = Σ r_vi x_i          images of the unit weft and warp vectors [–]
///   ε_uu = (U·U − 1)/2, ε_vv = (V·V − 1)/2, γ = U·V                 Green-Lagrange [–]
///   W = A [ w_u(ε_uu) + w_v(ε_vv) + C_uv ε_uu ε_vv + w_s(γ) ]                       [J]
///
/// A flat area [m²]. The shear is that of each triangle; the yarn strains are so only by a share α
/// (kTriangleShare), and by 1 − α means over the triangles round each vertex (StrainPatch p):
///
///   W = Σ_t A_t [α w_uv(ε_t) + w_s(γ_t)] + (1 − α) Σ_p A_p w_uv(ε_p)
///
/// w_uv all but the shear, A_p a third of the triangles of p: the same for every homogeneous strain.
/// Yarns that hardly stretch lay four conditions a vertex on a mesh of single triangles, for three
/// coordinates, so that it folds along its own edges only (locking); the means lay two. Source: Liu
/// et al. 2009 (nodal smoothing), docs/decisions/0012-yarn-strain-round-vertices.md. Without
/// measured curves this is St. Venant-Kirchhoff:
///
///   w_u = ½ C_uu ε_uu², w_v = ½ C_vv ε_vv², w_s = ½ G γ²
///   C_uu = K_u/(1−ν²), C_vv = K_v/(1−ν²), C_uv = ν √(K_u K_v)/(1−ν²)               [N/m]
///
/// K membrane stiffness [N/m], G [N/m]. A measured curve replaces w of its direction
/// (stress_curve.h). It is taken as measured with the width held, as KES-FB1 does: at ε_vv = 0 the
/// weft force is the curve, whatever ν. The coupling stays the constant C_uv = ν √(k_u k_v), k the
/// smallest tangent of w_u and w_v (zero if one is not positive): then an energy exists, it is
/// convex in the strains over the measured range, and a fabric that stiffens contracts relatively
/// less. A compression_factor c < 1 makes w c times softer at ε < 0; by the same rule the linear
/// law is then C_uu = K_u/(1−cν²), C_uv = c ν √(K_u K_v)/(1−cν²): W is convex and C¹, and a strip
/// pulled with free width still shows K and ν.
///
/// Strain-rate viscosity with damping time τ is the incremental potential of the stress τ C ε̇,
/// ε̇ ≈ (ε − ε_start)/dt, with C the tangent at the start of the step (without its negative part):
/// it vanishes for rigid motion and in statics. Source: Volino and Magnenat-Thalmann 2005; Volino,
/// Magnenat-Thalmann and Faure 2009.
class MembraneEnergy : public particles::Energy,
                       public particles::LaggedState,
                       public particles::ActiveSetUser {
 public:
  /// triangle_uv: flat corners (u weft, v warp) [m]; factor: stiffness multiplier per triangle.
  /// \throws GeometryError for a flat triangle without area; InvalidInput as StressCurve.
  MembraneEnergy(const std::vector<Triangle>& triangles,
                 const std::vector<std::array<Vec2, 3>>& triangle_uv,
                 const std::vector<double>& factor, const Material& material, bool viscous = false,
                 double triangle_share = kTriangleShare);

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

  /// Green strain (ε_uu, ε_vv, γ) and second Piola-Kirchhoff stress (s_uu, s_vv, s_uv) [N/m].
  /// The strain is that of the triangle, the stress what its corners feel.
  struct State {
    Vec3 strain, stress;
  };
  /// Of every triangle. \pre no active set
  std::vector<State> states(const particles::VectorField& x) const;
  State state(int triangle, const particles::VectorField& x) const { return states(x)[triangle]; }

 private:
  /// Second Piola-Kirchhoff stress without viscosity and factor, energy and tangent [N/m]; of the
  /// yarns the share of each triangle.
  void respond(const PlaneRows& strain, const particles::TileRow& share, PlaneResponse& out,
               PlaneTangent* tangent) const;
  /// Of the yarns alone at (ε_uu, ε_vv): energy, stress and tangent (C_uu, C_vv, C_uv).
  struct YarnResponse {
    double energy, stress_u, stress_v;
    Vec3 tangent;
  };
  YarnResponse respond_yarns(double uu, double vv) const;
  /// Strains of tiles into strain_, then energies and stresses of patches.
  void find_patches(const particles::VectorField& x) const;
  void add_patches(particles::BlockMatrix& h, particles::HessianKind kind) const;
  double evaluate(const particles::VectorField& x, bool forces) const;
  /// Strain, stress with viscosity and tangent of a tile.
  struct TileState {
    MembraneStrain s;
    PlaneResponse response;
    PlaneTangent tangent;
  };
  void tile_state(int tile, const particles::VectorField& x, bool with_tangent,
                  TileState& state) const;

  std::size_t count_ = 0;
  std::vector<MembraneTile> tiles_;
  double patch_share_ = 0;  ///< 1 − α
  StrainPatches patches_;
  std::vector<particles::TileRow> yarn_share_;  ///< of each triangle itself: α, more without patch
  std::vector<std::array<particles::TileIndex, 3>> patch_at_;  ///< places in patch_stress_
  std::vector<double> factor_;
  bool plain_;                         ///< one constant matrix: no curve, no soft compression
  PlaneTangent linear_;                ///< of the plain law, the same for all
  StressCurve law_u_, law_v_, law_s_;  ///< of all others
  double coupling_ = 0;                ///< C_uv of all others [N/m]
  double damping_ = 0;                 ///< τ [s]
  double viscous_ratio_ = 0;           ///< τ/dt of the current step
  std::vector<PlaneRows> strain_start_;
  std::vector<PlaneTangent> tangent_start_;  ///< only for laws that are not plain

  const particles::ActiveSet* active_set_ = nullptr;
  particles::IndexSubset active_tiles_;
  /// Patches that the active set moves, and the tiles of their triangles.
  particles::IndexSubset active_patches_, strained_tiles_;

  particles::ParticleGather to_particles_;
  particles::BlockGather to_blocks_;
  // Room that is kept from call to call: an energy belongs to one thread at a time.
  mutable std::vector<double> energy_;          ///< per tile
  mutable std::vector<Vec3> force_;             ///< per corner
  mutable std::vector<Mat3> block_;             ///< six per triangle
  mutable std::vector<MembraneStrain> strain_;  ///< per tile, where there are patches
  mutable std::vector<double> patch_energy_;
  mutable std::vector<Vec2> patch_strain_, patch_stress_;      ///< the last stress stays 0
  mutable std::unique_ptr<StrainPatchTangent> patch_tangent_;  ///< made when it is first asked for
};

}  // namespace loosefit::fabric

#pragma once
#include <memory>
#include <vector>

#include "loosefit/fabric/bending_friction.h"
#include "loosefit/fabric/curvature_patch.h"
#include "loosefit/fabric/hinge_kernel.h"
#include "loosefit/fabric/material.h"
#include "loosefit/fabric/patch_kernel.h"
#include "loosefit/fabric/patch_tangent.h"
#include "loosefit/particles/block_gather.h"
#include "loosefit/particles/energy_capabilities.h"
#include "loosefit/particles/particle_gather.h"

namespace loosefit::fabric {

/// Rigidity of an orthotropic plate for (κ_uu, κ_vv, 2κ_uv) [N m]: D_u = B_u, D_v = B_v,
/// D_12 = ν_b √(D_u D_v), D_66 = (1 − ν_b) √(D_u D_v)/2 (docs/theory/materials.md 7), plus an
/// isotropic sheet of rigidity `added` and the same ν_b. B is the rigidity of a wide sheet; a
/// narrow strip, free to contract sideways, bends with B (1 − ν_b²).
Mat3 plate_rigidity(const Material& material, double added = 0);

/// Bending of a sewn garment: an orthotropic Kirchhoff plate on curvature patches,
///
///   W = Σ A [ ½ κᵀ D κ + w_friction(κ) ],   κ = S θ                                [J]
///
/// with θ the dihedral angles round a triangle (CurvaturePatch), D of plate_rigidity plus what
/// attachments add, and the inner friction of BendingFriction. Rest angle 0, seams included.
/// Viscosity as in MembraneEnergy: the stress τ D κ̇.
/// The hinge tangent gives each hinge a stiffness of its own (the diagonal of the fit with a
/// triangle's own angles, CurvaturePatch step 1): four particles a hinge instead of twelve a
/// triangle. The projected one of either tangent leaves out the moments of hinges that are nearly
/// flat and takes the positive part of the others (hinge_definite_blocks). The memory of the inner
/// friction starts from flat cloth: what is bent at first has been bent there in one go.
class BendingEnergy : public particles::Energy,
                      public particles::LaggedState,
                      public particles::TangentChoice,
                      public particles::ActiveSetUser {
 public:
  BendingEnergy(const std::vector<Triangle>& triangles,
                const std::vector<std::array<Vec2, 3>>& triangle_uv,
                const std::vector<double>& added_rigidity, const Material& material,
                bool viscous = false, const std::vector<char>& built_in = {});

  /// Curvature (κ_uu, κ_vv, 2κ_uv) of a triangle [1/m], positive where the outside is convex.
  Vec3 curvature(int triangle, const particles::VectorField& x) const;

  /// Where the yarns have slid to: the memory of the inner friction, to be taken up again by
  /// `recall` of the same cloth.
  const std::vector<PlaneRows>& memory() const { return anchor_; }
  void recall(const std::vector<PlaneRows>& memory) { anchor_ = memory; }

  void set_tangent(particles::BendingTangent tangent) override {
    pattern_version_ += tangent != tangent_;  // each tangent has a pattern of its own
    tangent_ = tangent;
  }
  void set_active_set(const particles::ActiveSet* active_set) override;
  void begin_step(const particles::VectorField& x, double dt) override;
  double value(const particles::VectorField& x) const override;
  void add_gradient(const particles::VectorField& x, particles::VectorField& g) const override;
  double value_and_gradient(const particles::VectorField& x,
                            particles::VectorField& g) const override;
  void add_pattern(const particles::VectorField& x,
                   particles::BlockPattern& pattern) const override;
  std::uint64_t pattern_version(const particles::VectorField&) const override {
    return pattern_version_;
  }
  void add_hessian(const particles::VectorField& x, particles::BlockMatrix& h,
                   particles::HessianKind kind) const override;

 private:
  /// A tile of hinges; missing ones at the end repeat the first.
  struct HingeTile {
    std::array<particles::TileIndex, 4> corner;
    std::array<particles::TileIndex, 6> moment;  ///< places in moment_ that act about it
    std::array<particles::TileIndex, 2> own;     ///< places in friction_stiffness_
    particles::TileRow stiffness;                ///< of the hinge tangent [N m]
  };
  void build_tiles(const std::vector<Mat3>& rigidity);
  /// Angles into angle_, with gradients into gradient_ if these are wanted.
  void find_angles(const particles::VectorField& x, bool with_gradient) const;
  /// Energy, with angles into angle_; on demand also their gradients into gradient_ and the moments
  /// about the hinges into moment_.
  double bend(const particles::VectorField& x, bool with_moments) const;
  void patch_response(int tile, PlaneRows& curvature, PlaneResponse& response) const;
  particles::TileRow moments_about(const HingeTile& tile) const;
  Mat3 friction_tangent(const PlaneRows& curvature, int tile, int i) const;
  particles::TileRow hinge_stiffness(const HingeTile& tile) const;
  void find_friction_stiffness() const;
  void add_patches(particles::BlockMatrix& h) const;
  PatchTangent& patch_tangent() const;

  CurvaturePatches mesh_;
  std::vector<HingeTile> hinge_tiles_;
  std::vector<PatchTile> patch_tiles_;
  BendingFriction friction_;
  particles::BendingTangent tangent_ = particles::BendingTangent::plate;
  std::uint64_t pattern_version_ = 0;
  std::vector<PlaneRows> anchor_;  ///< z₀ of the inner friction, per patch
  double damping_ = 0;             ///< τ [s]
  double viscous_ratio_ = 0;       ///< τ/dt of the current step
  std::vector<PlaneRows> curvature_start_;

  const particles::ActiveSet* active_set_ = nullptr;
  /// Tiles of hinges that bear forces, tiles of patches that bend, and those of their hinges.
  particles::IndexSubset turning_, bending_, bent_;

  particles::ParticleGather to_particles_;
  particles::BlockGather to_blocks_;
  mutable std::unique_ptr<PatchTangent> patch_tangent_;  ///< made when it is first asked for
  // Room that is kept from call to call: an energy belongs to one thread at a time.
  mutable std::vector<double> angle_;  ///< per hinge [rad]; the last stays 0
  mutable std::vector<HingeGradient> gradient_;
  mutable std::vector<double> energy_;  ///< per tile of patches
  mutable std::vector<double> moment_;  ///< rows of nine per tile of patches; the last stays 0
  mutable std::vector<double> friction_stiffness_;  ///< rows of three, likewise
  mutable std::vector<Vec3> force_;                 ///< four per hinge
  mutable std::vector<Mat3> block_;                 ///< ten per hinge
};

}  // namespace loosefit::fabric

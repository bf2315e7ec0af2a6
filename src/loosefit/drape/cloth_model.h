#pragma once
#include <memory>
#include <vector>

#include "loosefit/contact/body_contact.h"
#include "loosefit/contact/self_contact.h"
#include "loosefit/drape/drape_garment.h"
#include "loosefit/drape/unsettled.h"
#include "loosefit/fabric/bending_energy.h"
#include "loosefit/fabric/membrane_energy.h"
#include "loosefit/particles/gravity_energy.h"
#include "loosefit/solver/particle_system.h"

namespace loosefit {

inline constexpr double kStickReach = 1e-4;  ///< elastic creep before Coulomb slip [m]

/// What cloth remembers of its past: where it sticks, and how its yarns lie.
struct ClothMemory {
  BodyContact body;
  SelfContact self;
  std::vector<PlaneRows> bending;
};

/// All energies of one garment level and the particle system that refers to them.
class ClothModel {
 public:
  /// self_thickness: distance at which layers begin to repel [m].
  ClothModel(const Garment& garment, const Material& material, const DrapeOptions& options,
             double self_thickness);
  ClothModel(const ClothModel&) = delete;
  ClothModel& operator=(const ClothModel&) = delete;

  ParticleSystem& system() { return system_; }
  BodyContact& body() { return *body_; }
  SelfContact& self() { return *self_; }
  const BodyContact& body() const { return *body_; }

  /// Forces on every particle [N], by kind in the order of kForceNames.
  using Forces = std::array<VectorField, kForceNames.size()>;
  Forces forces(const VectorField& x) const;

  /// Replaces the layer that touches the body by one of that thickness [m], as much softer as it is
  /// thicker than half the fabric; 0: by the fabric itself.
  void pad_body(double thickness);

  ClothMemory memory() const { return {*body_, *self_, bending_->memory()}; }
  /// Takes up what this model remembered earlier.
  void recall(const ClothMemory& memory);

 private:
  std::unique_ptr<MembraneEnergy> membrane_;
  std::unique_ptr<BendingEnergy> bending_;
  std::unique_ptr<GravityEnergy> gravity_;
  std::unique_ptr<BodyContact> body_;
  std::unique_ptr<SelfContact> self_;
  double half_thickness_, layer_stiffness_;
  ParticleSystem system_;
};

/// Flat areas of the triangles [m²].
std::vector<double> flat_areas(const Garment& garment);

}  // namespace loosefit

#pragma once
#include <memory>
#include <vector>

#include "loosefit/contact/body_contact.h"
#include "loosefit/contact/contact_lattice.h"
#include "loosefit/contact/self_contact.h"
#include "loosefit/drape/cloth_layer.h"
#include "loosefit/drape/contact_body.h"
#include "loosefit/drape/drape_options.h"
#include "loosefit/drape/unsettled.h"
#include "loosefit/fabric/band_energy.h"
#include "loosefit/fabric/bending_energy.h"
#include "loosefit/fabric/board_energy.h"
#include "loosefit/fabric/membrane_energy.h"
#include "loosefit/particles/dead_load.h"
#include "loosefit/particles/gravity_energy.h"
#include "loosefit/solver/particle_system.h"

namespace loosefit::drape {

/// What cloth remembers of its past: where it sticks, and how its yarns lie.
struct ClothMemory {
  std::vector<contact::BodyContact::Memory> body;   ///< per layer
  std::vector<contact::BodyContact::Memory> floor;  ///< per layer
  std::vector<contact::ContactLattice> lattice;     ///< per layer
  contact::SelfContact::Memory self;
  std::vector<std::vector<fabric::PlaneRows>> bending;
};

/// One layer on one level, as its energies see it.
struct ModelLayer {
  const garment::Garment* garment = nullptr;
  fabric::Material material;
  double self_thickness = 5e-4;  ///< distance at which it begins to repel cloth, shared by both [m]
  std::optional<double> friction_over = {};  ///< as ClothLayer::friction_over
  /// It goes under the soles, as a sock does: the floor on which the skin stands is not for it.
  bool under_soles = false;
};

/// μ between each two layers [–], symmetric, friction_self on the diagonal.
Eigen::MatrixXd layer_friction(const std::vector<ModelLayer>& layers);

/// All energies of one level of a garment, or of several worn over each other, and the particle
/// system that refers to them. Each layer has its own elasticity and its own contact with the body;
/// contact of cloth with cloth is one for all.
class ClothModel {
 public:
  ClothModel(const std::vector<ModelLayer>& layers, const DrapeOptions& options);
  /// self_thickness: distance at which layers begin to repel [m].
  ClothModel(const garment::Garment& garment, const fabric::Material& material,
             const DrapeOptions& options, double self_thickness);
  ClothModel(const ClothModel&) = delete;
  ClothModel& operator=(const ClothModel&) = delete;

  solver::ParticleSystem& system() { return system_; }
  const ClothMesh& mesh() const { return mesh_; }
  contact::BodyContact& body(int layer = 0) { return *body_[layer]; }
  contact::SelfContact& self() { return *self_; }
  const contact::BodyContact& body(int layer = 0) const { return *body_[layer]; }
  /// Of the points of that contact.
  contact::ContactLattice& lattice(int layer = 0) { return lattice_[layer]; }
  /// What every layer touches, the skin and the floor; both are kept.
  void set_body(const ContactBody& body);
  /// Triangles that reach below the floor, ascending.
  std::vector<int> below_floor(const particles::VectorField& x) const;
  /// Σ of the normal forces of the floor on all layers [N].
  double floor_force(const particles::VectorField& x) const;

  /// Forces on every particle [N], by kind in the order of kForceNames; those of bands and
  /// boards that are sewn on are counted with the membrane, those of the floor with the body.
  using Forces = std::array<particles::VectorField, kForceNames.size()>;
  Forces forces(const particles::VectorField& x) const;

  /// Replaces the layer that touches the body by one of that thickness [m], as much softer as it is
  /// thicker than half the fabric; 0: by the fabric itself.
  void soften_body_contact(double thickness);
  /// As contact::BodyContact::set_hardening.
  void set_hardening(double share);

  /// Friction holds this share of what it holds at rest [–], on the body and between layers of
  /// cloth. Anchors stay; forget_anchors lets go of all.
  void set_friction_share(double share);
  void forget_anchors();

  /// Takes the weight off the cloth; residuals still refer to it.
  void take_weight() {
    gravity_->set_gravity(0);
    boards_->set_gravity(0);
  }

  /// Pulls at the particles [N], one force each, until told otherwise; none: lets go. `forces` does
  /// not list it.
  void set_load(particles::VectorField forces) { load_->set_forces(std::move(forces)); }
  bool is_loaded() const { return !load_->forces().empty(); }

  ClothMemory memory() const;
  /// Takes up what this model remembered earlier.
  void recall(const ClothMemory& memory);

 private:
  ClothMesh mesh_;
  std::vector<std::unique_ptr<fabric::MembraneEnergy>> membrane_;  // one a layer
  std::vector<std::unique_ptr<fabric::BendingEnergy>> bending_;
  std::vector<std::unique_ptr<fabric::BandEnergy>> bands_;
  std::unique_ptr<fabric::BoardEnergy> boards_;  // of all layers
  std::unique_ptr<particles::GravityEnergy> gravity_;
  std::unique_ptr<particles::DeadLoad> load_;
  std::vector<std::unique_ptr<contact::BodyContact>> body_;   // per layer, with the skin
  std::vector<std::unique_ptr<contact::BodyContact>> floor_;  // per layer
  std::vector<char> under_soles_;                             // per layer
  std::shared_ptr<const contact::Floor> floor_surface_;
  std::vector<contact::ContactLattice> lattice_;  // per layer
  std::unique_ptr<contact::SelfContact> self_;
  std::vector<double> half_thickness_, contact_stiffness_;  // per layer
  solver::ParticleSystem system_;
};

}  // namespace loosefit::drape

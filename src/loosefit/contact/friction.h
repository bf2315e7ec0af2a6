#pragma once
#include <cstdint>
#include <limits>
#include <vector>

#include "loosefit/contact/contact_tuning.h"
#include "loosefit/particles/energy_capabilities.h"

namespace loosefit::contact {

/// One frictional contact, frozen at the start of a step: the relative point Σ w_k x_k may slide in
/// the plane normal to `normal`. For body contact the weights sum to 1, for self contact to 0.
struct FrictionContact {
  std::uint64_t key = 0;  ///< identity of the contact across steps
  std::array<int, 4> particle{};
  std::array<double, 4> weight{};
  int count = 0;
  Vec3 normal = Vec3::UnitZ();
  double normal_force = 0;       ///< λ ≥ 0 [N]
  Vec3 offset = Vec3::Zero();    ///< elastic tangential displacement at the start of the step [m]
  double relative_friction = 1;  ///< μ of this contact as a share of the coefficient of Friction
  int lost = 0;                  ///< iterations since it last bore a force; Friction counts them
  double relaxation = 1;         ///< share of the last change that was taken; set by Friction
  double change = 0;             ///< that change of the normal force [N]; set by Friction
};

/// Coulomb friction with lagged normal force as an incremental potential
///
///   Π = Σ μ λ f₀(|u|),  u = (I − n nᵀ)(u₀ + Σ w_k (x_k − x_k,start))                        [J]
///   f₀' = s (2 − s) for s = |u|/ε < 1, 1 beyond (C¹)
///
/// so |F_t| ≤ μ λ always, sticking is a spring of reach ε [m], and sliding dissipates because
/// `restart` moves the anchor: the stored u is returned to the circle |u| ≤ ε (elastic predictor,
/// plastic corrector). Not conservative over steps; within a step it is a potential.
///
/// Iterations on one static balance are not steps of a history: the normal forces are still on
/// their way, and where they lag behind, the cloth slides too far. So between them `iterate` renews
/// normals and normal forces but lets the anchor trail by up to FrictionTuning::memory ε, also
/// through a lost contact; what slid too far comes back, and the forces end on the cone that
/// belongs to the final normal forces. A contact that friction opens and its loss closes would
/// alternate for ever: where a normal force turns back, only a share of its change is taken (Silva
/// and Almeida 1990), and `lagged_friction_force` tells how much that leaves out. Source: Coulomb;
/// smoothing as in Li et al. 2020 (IPC) eq. 19; return mapping, Simo and Hughes 1998.
class Friction {
 public:
  /// lost_iterations: for how many of them a lost contact keeps its anchor; see `iterate`.
  Friction(double coefficient, double stick_reach,
           int lost_iterations = std::numeric_limits<int>::max())
      : coefficient_(coefficient), reach_(stick_reach), lost_iterations_(lost_iterations) {}
  double coefficient() const { return coefficient_; }
  /// All contacts hold this share of what they hold at rest [–], until told otherwise.
  void set_share(double share) { share_ = share; }
  double share() const { return share_; }

  /// Contacts of the new step at x (sorted by key); contacts known before keep their anchors.
  void restart(std::vector<FrictionContact> contacts, const particles::VectorField& x);
  /// The same for another iteration on the static balance of the present step.
  void iterate(std::vector<FrictionContact> contacts, const particles::VectorField& x);
  /// What the cloth rubs against has moved by `motion` [m], given at each particle: the anchors go
  /// along, so that only motion relative to it counts as sliding.
  void carry(const particles::VectorField& motion);
  /// Drops all contacts with their anchors.
  void forget() {
    contacts_.clear();
    set_active_set(nullptr);
  }
  /// Takes up contacts and anchors of `other`, but not its share, which belongs to what the wearer
  /// does now.
  void recall(const Friction& other) {
    const double share = share_;
    *this = other;
    share_ = share;
  }
  /// As Energy::set_active_set. Ends when the contacts change.
  void set_active_set(const particles::ActiveSet* active_set);

  /// Norm of the friction that the shares of `iterate` left out [N].
  double lagged_friction_force() const { return lagged_force_; }

  double value(const particles::VectorField& x) const;
  void add_gradient(const particles::VectorField& x, particles::VectorField& g) const {
    value_and_gradient(x, g);
  }
  double value_and_gradient(const particles::VectorField& x, particles::VectorField& g) const;
  void add_pattern(particles::BlockPattern& pattern) const;
  void add_hessian(const particles::VectorField& x, particles::BlockMatrix& h) const;
  const std::vector<FrictionContact>& contacts() const { return contacts_; }

 private:
  /// μ λ of one contact [N].
  double strength(const FrictionContact& c) const {
    return coefficient_ * share_ * c.relative_friction * c.normal_force;
  }
  Vec3 slide(const FrictionContact& c, const particles::VectorField& x) const;
  void carry_anchors(std::vector<FrictionContact>& contacts, const particles::VectorField& x,
                     double reach) const;
  double relax(FrictionContact& contact, const FrictionContact& old, double normal_force) const;
  double coefficient_, reach_, share_ = 1, lagged_force_ = 0;
  int lost_iterations_;
  std::vector<FrictionContact> contacts_;
  particles::IndexSubset active_contacts_;  ///< contacts
  particles::VectorField start_;
};

}  // namespace loosefit::contact

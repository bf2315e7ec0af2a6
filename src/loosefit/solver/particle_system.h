#pragma once
#include <array>
#include <vector>

#include "loosefit/particles/energy_capabilities.h"

namespace loosefit::solver {

/// Particles that stay in one affine image of their places at rest: a rigid board, whose own energy
/// (fabric/board_energy.h) keeps that image a turned one. Each follower is Σ weight · leader, so
/// straight lines, the search along them and collision detection stay what they are, and the matrix
/// loses unknowns instead of getting stiff ones. After Lan et al. 2022 (affine body dynamics).
struct Plate {
  std::array<int, 3> leaders{};
  std::vector<int> followers;  ///< none of them a leader, held, or of another plate
  std::vector<Vec3> weights;   ///< of each follower; they sum to 1
};

/// What the integrators see of a garment: particles, energies, masses, held particles. It does not
/// own the energies. Each function asks the energies that have the capability in question
/// (energy_capabilities.h).
struct ParticleSystem {
  std::vector<particles::Energy*> energies;
  std::vector<double> mass;  ///< [kg]
  /// Masses whose weight residuals refer to [kg]: those of the cloth without the boards on it,
  /// which are a load. Empty: all of `mass`.
  std::vector<double> cloth_mass;
  /// Non-zero: a held particle, which does not move (Dirichlet condition); empty: all are free.
  std::vector<char> held;
  std::vector<Plate> plates;
  double gravity = 9.80665;  ///< only for the weight in the residual [m/s²]

  int particles() const { return static_cast<int>(mass.size()); }
  bool is_held(int i) const { return !held.empty() && held[i]; }

  /// Non-zero: held, or a follower of a plate, so no unknown; empty: all are unknowns.
  std::vector<char> no_unknown() const;
  /// Non-zero: leader or follower of a plate; empty: there are no plates.
  std::vector<char> on_plate() const;
  /// Mass as the unknowns feel it [kg]: of leaders an upper bound of what they carry (row sums),
  /// so that a shift by it never makes a matrix less definite.
  std::vector<double> carried_mass() const;
  /// Forces on followers go to their leaders.
  void gather_forces(particles::VectorField& force) const;
  /// Followers move as their leaders do.
  void move_followers(particles::VectorField& dx) const;
  /// Moves plates that something other than a solver has bent to the affine image that fits best,
  /// as far as nothing is met on the way. Returns whether anything moved.
  bool flatten_plates(particles::VectorField& x) const;

  void set_tangent(particles::BendingTangent tangent) const;
  void set_active_set(const particles::ActiveSet* active_set) const;
  void begin_step(const particles::VectorField& x, double dt) const;
  double max_step(const particles::VectorField& x, const particles::VectorField& dx) const;
  double potential(const particles::VectorField& x) const;
  /// ∂Π/∂x, zero for held particles; that of followers is at their leaders.
  particles::VectorField gradient(const particles::VectorField& x) const;
  /// Both at once; returns Π.
  double potential_and_gradient(const particles::VectorField& x, particles::VectorField& g) const;
  /// ‖friction force‖ by which the lagged state departs from what the last place asks for [N].
  double lagged_friction_force() const;
  /// Changes when the union of all energies' patterns may have changed.
  std::uint64_t pattern_version(const particles::VectorField& x) const;
};

/// Force balance of free particles: ‖F‖₂/‖W‖₂ and max‖F_i‖ / mean‖W_i‖ (docs/theory/solver.md 1),
/// W the weight of the cloth alone (ParticleSystem::cloth_mass): a heavy board must not excuse a
/// force that the cloth would not have been allowed without it.
/// The lagged friction force of the energies counts as a force.
struct Residual {
  double norm = 0, largest = 0;
  int worst_particle = -1;
};
Residual residual_of(const ParticleSystem& system, const particles::VectorField& gradient);

}  // namespace loosefit::solver

#pragma once
#include "loosefit/particles/active_set.h"
#include "loosefit/particles/energy.h"

namespace loosefit::particles {

// What an energy may be besides a potential. An energy inherits the classes that apply to it;
// ParticleSystem asks each energy which they are.

/// Lagged state: contact sets, friction anchors, strains at the start of a time step. It changes
/// only in `begin_step`.
class LaggedState {
 public:
  virtual ~LaggedState() = default;
  /// A new time step of length dt [s] starts at x. dt = ∞: no time passes, x is the next iterate of
  /// the static balance of the step that began last.
  virtual void begin_step(const VectorField& x, double dt) = 0;
  /// ‖friction force‖ [N] by which the state of the last `begin_step` lags behind the one that its
  /// place asks for; part of the residual.
  virtual double lagged_friction_force() const { return 0; }
};

/// Collision limit of a step: continuous collision detection (CCD).
class StepLimit {
 public:
  virtual ~StepLimit() = default;
  /// A line search from x along dx is about to start: brings the contact set up to date for all
  /// places on it. Returns the largest share in (0, 1] of dx that is free of collisions.
  virtual double max_step(const VectorField& x, const VectorField& dx) = 0;
};

/// Stencil of the bending Hessian. The hinge tangent costs half as much and lies close enough to
/// the exact one for Newton's method to converge, if only linearly.
enum class BendingTangent {
  hinge,  ///< a stiffness per hinge, four particles
  plate,  ///< the derivative of the gradient, which couples the hinges of a plate patch
};

/// An energy that offers a cheaper Hessian on a narrow stencil.
class TangentChoice {
 public:
  virtual ~TangentChoice() = default;
  /// Applies to add_pattern and add_hessian until the next call; energies start with `plate`.
  virtual void set_tangent(BendingTangent tangent) = 0;
};

/// An energy that saves work while only an active set of particles moves. All other energies do the
/// full work, which is also right.
class ActiveSetUser {
 public:
  virtual ~ActiveSetUser() = default;
  /// From this call on only particles of the active set move. What touches none of them may be left
  /// out of the energy, which then is right but for a constant; forces on other particles are void,
  /// and so is the Hessian but for blocks with both particles in the active set. No `begin_step` in
  /// between. The set must live until it is replaced; null: all particles again, and what the last
  /// `max_step` found holds for all of them.
  virtual void set_active_set(const ActiveSet* active_set) = 0;
};

}  // namespace loosefit::particles

#pragma once
#include <functional>
#include <limits>

#include "loosefit/solver/rest_tolerance.h"
#include "loosefit/solver/settle_outcome.h"

namespace loosefit::solver {

/// When to stop settling, and what to tell on the way.
struct SettleOptions {
  double tolerance = kRestTolerance;  ///< ‖F‖₂/‖W‖₂ [–]
  /// max‖F_i‖ / mean‖W_i‖ besides [–].
  double largest = std::numeric_limits<double>::infinity();
  int max_iterations = 1000;  ///< Newton iterations, or time steps of the dynamic integrators
  double max_move = 0.02;     ///< largest particle move per step, of all or of a region [m]
  double first_dt = 0.01;     ///< first pseudo-time step, or the time step of implicit Euler [s]
  /// Matrix of the Newton steps of the quasi-static integrator: changes the way and its cost, not
  /// the equilibrium. The plate tangent takes over when the hinge tangent finds no descent.
  particles::BendingTangent tangent = particles::BendingTangent::plate;
  /// Called about once per iteration with (iteration, residual); true asks to stop.
  std::function<bool(int, double)> watch;

  RestGoal goal() const { return {tolerance, largest}; }
};

/// Moves particles until their forces balance. All kinds (quasi_static.h, implicit_euler.h,
/// semi_implicit_euler.h) share this interface and one meaning of rest: the static residual of all
/// energies, friction included, without inertia and viscosity.
class Integrator {
 public:
  virtual ~Integrator() = default;
  virtual SettleOutcome settle(particles::VectorField& x, const SettleOptions& options) = 0;
};

}  // namespace loosefit::solver

#pragma once
#include "loosefit/particles/energy.h"
#include "loosefit/solver/newton_step.h"
#include "loosefit/solver/solver_work.h"

namespace loosefit::solver {

/// Minimises the energy of one (pseudo-)time step,  Π(x) + Σ m_i/(2 dt²) |x_i − x̂_i|²,  an
/// iteration at a time. Newton is the one of the program; bench/solver races others in the same
/// outer loop.
class DescentMethod {
 public:
  virtual ~DescentMethod() = default;
  /// Counts work anew; the particles may have been moved and contacts changed. max_move: largest
  /// move of a particle in one step [m].
  virtual void restart(double max_move) = 0;
  /// One iteration. target = x̂, dt [s]; dt = ∞ leaves out the inertia term.
  virtual StepOutcome iterate(particles::VectorField& x, const particles::VectorField& target,
                              double dt) = 0;
  /// LaggedState::begin_step of all energies.
  virtual void begin_step(const particles::VectorField& x, double dt) = 0;
  /// ∂Π/∂x at x [N], remembered until x or the energies change. \post the next `iterate` at x is
  /// cheaper
  virtual const particles::VectorField& gradient(const particles::VectorField& x) = 0;
  virtual const SolverWork& work() const = 0;
};

}  // namespace loosefit::solver

#pragma once
#include "loosefit/solver/inertia_term.h"
#include "loosefit/solver/line_search.h"
#include "loosefit/solver/matrix_choice.h"

namespace loosefit::solver {

/// A place with what a solver knows there.
struct Iterate {
  particles::VectorField x;         ///< [m]
  double potential = 0;             ///< Π [J], without inertia
  particles::VectorField gradient;  ///< ∂Π/∂x [N]
};

/// What one Newton step did.
struct StepOutcome {
  bool moved = false;            ///< false: no descent possible
  double share = 0;              ///< accepted multiple of the Newton step, collisions included
  double force = 0;              ///< ‖∂(Π + inertia)/∂x‖ before the move [N]
  bool exact = false;            ///< its matrix was the exact Hessian
  bool below_round_off = false;  ///< as in SearchResult
};

/// One step of Newton's method for  min_x Π(x) + Σ m_i/(2 dt²) |x_i − x̂_i|²:  choose a definite
/// matrix, solve for the direction, limit it by max_move and by collisions, search along it. Keeps
/// what it learned (whether the last step was taken whole, how far steps may be extended).
class NewtonStep {
 public:
  NewtonStep(const MatrixTuning& matrix, const LineSearchTuning& search, const StepTuning& step)
      : matrix_(matrix), search_(search), tuning_(step), extension_(step.first_extension) {}

  /// Moves `at` by one step, unless the force is not above min_force [N] or there is no descent.
  /// \pre `at` has been evaluated by the problem
  StepOutcome take(NewtonProblem& problem, const InertiaTerm& inertia, Iterate& at,
                   double min_force = 0);
  void set_max_move(double max_move) { tuning_.max_move = max_move; }
  double max_move() const { return tuning_.max_move; }

 private:
  MatrixTuning matrix_;
  LineSearchTuning search_;
  StepTuning tuning_;
  bool calm_ = true;  ///< the last step was taken whole
  double extension_;  ///< how far to look along a step whose matrix is not exact
};

}  // namespace loosefit::solver

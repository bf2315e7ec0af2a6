#pragma once
#include "loosefit/solver/solver_tuning.h"

namespace loosefit::solver {

/// The energy along a search direction, φ(t) = E(x(t)), with one trial point at a time.
class SearchLine {
 public:
  virtual ~SearchLine() = default;
  /// φ(t) [J]; moves the trial point to t.
  virtual double energy(double t) = 0;
  /// φ'(t) at the trial point [J].
  virtual double slope() = 0;
  /// ‖∂E/∂x‖² at the trial point [N²].
  virtual double squared_force() = 0;
  /// The trial point is the best one so far.
  virtual void keep() = 0;
};

/// What is known before a line search.
struct SearchStart {
  double energy = 0;  ///< φ(0) [J]
  double slope = 0;   ///< φ'(0) < 0 [J]
  double force = 0;   ///< ‖∂E/∂x‖ at t = 0 [N]
  double first = 1;   ///< first trial, the Newton step itself
  double limit = 1;   ///< largest t that is free of collisions
};

struct SearchResult {
  bool found = false;
  double t = 0;  ///< of the point that was kept last
  /// The decrease was too small for the energy to show: a smaller force decided.
  bool below_round_off = false;
};

/// Line search with Armijo's rule φ(t) ≤ φ(0) + c t φ'(0): backtracks by halving, or doubles a
/// first trial that was accepted while a parabola through both slopes expects a lower energy at
/// twice the step and finds it there.
SearchResult line_search(SearchLine& line, const SearchStart& start,
                         const LineSearchTuning& tuning);

}  // namespace loosefit::solver

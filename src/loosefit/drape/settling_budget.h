#pragma once
#include <chrono>

#include "loosefit/drape/drape_options.h"

namespace loosefit::drape {

/// Time and iterations of one drape. The clock runs from construction.
class SettlingBudget {
 public:
  /// Keeps a reference to the options.
  explicit SettlingBudget(const DrapeOptions& options) : options_(options) {}

  double seconds() const;
  bool time_is_up() const;
  /// Iterations that were counted so far; explicit steps count as they are.
  int iterations() const { return iterations_; }
  /// `explicit_steps`: they count as IntegratorTuning says.
  void count(int iterations, bool explicit_steps);

  /// Iterations that are left of DrapeOptions::max_iterations.
  int iterations_left() const;
  /// Whether as many iterations are left as were used. The clock is not asked: what is tried must
  /// not depend on the machine.
  bool is_half_left() const { return 2 * spent_ <= options_.max_iterations; }
  /// Ends a phase of its own after so many more iterations, whatever the drape may take.
  void limit_phase(int iterations) {
    phase_length_ = iterations;
    phase_end_ = iterations_ + iterations;
  }
  int phase_length() const { return phase_length_; }  ///< iterations of that phase
  /// Whether those, with `more` that are not counted yet, are used up.
  bool phase_is_over(int more = 0) const {
    return phase_end_ >= 0 && iterations_ + more > phase_end_;
  }

 private:
  using Clock = std::chrono::steady_clock;
  const DrapeOptions& options_;
  Clock::time_point start_ = Clock::now();
  int iterations_ = 0;
  double spent_ = 0;    ///< of max_iterations
  int phase_end_ = -1;  ///< in iterations_; −1: none
  int phase_length_ = 0;
};

}  // namespace loosefit::drape

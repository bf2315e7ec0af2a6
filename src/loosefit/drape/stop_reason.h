#pragma once
#include <string>
#include <vector>

#include "loosefit/solver/settle_outcome.h"

namespace loosefit::drape {

/// Why settling a drape ended.
enum class StopReason {
  unknown,           ///< of a drape that was read from a file: its text says why
  converged,         ///< the tolerance is met
  time_budget,       ///< DrapeOptions::time_budget is used up
  iteration_limit,   ///< DrapeOptions::max_iterations are used up
  no_descent,        ///< no step lowers the energy
  diverged,          ///< forces that are no numbers
  cloth_falls,       ///< the cloth has left the body
  pieces_fall,       ///< pieces that are sewn to nothing else have left it
  caught_in_skin,    ///< cloth lies between folds of skin, a posture was given up
  posture_too_long,  ///< a posture took too many iterations and was given up
  no_progress,       ///< the net force goes up and down and falls no further (StallTuning)
  slides_down        ///< the same, and the cloth sinks meanwhile
};

/// The reason with what its sentence needs. The sentence is what certificates show.
struct Stop {
  StopReason reason = StopReason::unknown;
  double depth = 0;  ///< caught_in_skin: how deep [m]
  /// posture_too_long: allowed on the finest level; no_progress, slides_down: in which there was
  /// none.
  int iterations = 0;
  double residual = 0;                   ///< no_progress: the lowest [–]
  double sunk = 0;                       ///< slides_down: the middle of the cloth [m]
  int pieces = 0;                        ///< pieces_fall: how many
  std::vector<std::string> panels = {};  ///< pieces_fall: their panels, fit for printing

  std::string text() const;
};

/// As the integrators say it.
StopReason stop_reason(solver::SettleOutcome::Reason reason);

/// Whether nothing holds the cloth, all of it or pieces.
inline bool falls(StopReason reason) {
  return reason == StopReason::cloth_falls || reason == StopReason::pieces_fall ||
         reason == StopReason::slides_down;
}

}  // namespace loosefit::drape

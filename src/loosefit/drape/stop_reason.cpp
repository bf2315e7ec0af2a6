#include "loosefit/drape/stop_reason.h"

#include <fmt/format.h>

#include "loosefit/base/text.h"

namespace loosefit::drape {
namespace {

constexpr std::size_t kMostNames = 6;

std::string pieces_text(const Stop& stop) {
  std::vector<std::string> names = stop.panels;
  const bool one = names.size() == 1;
  if (names.size() > kMostNames) {
    names.resize(kMostNames);
    names.back() += ", …";
  }
  return (one ? "panel " : "panels ") + join(names) + (one ? " is" : " are") +
         " sewn to nothing that stays on the body and " + (stop.pieces == 1 ? "falls" : "fall") +
         " freely";
}

}  // namespace

StopReason stop_reason(solver::SettleOutcome::Reason reason) {
  switch (reason) {
    case solver::SettleOutcome::Reason::converged:
      return StopReason::converged;
    case solver::SettleOutcome::Reason::iteration_limit:
      return StopReason::iteration_limit;
    case solver::SettleOutcome::Reason::stopped:
      return StopReason::time_budget;
    case solver::SettleOutcome::Reason::stuck:
      return StopReason::no_descent;
    case solver::SettleOutcome::Reason::diverged:
      return StopReason::diverged;
  }
  return StopReason::unknown;
}

std::string Stop::text() const {
  switch (reason) {
    case StopReason::unknown:
      return {};
    case StopReason::converged:
      return "converged";
    case StopReason::time_budget:
      return "time budget";
    case StopReason::iteration_limit:
      return "iteration limit";
    case StopReason::no_descent:
      return "no further descent";
    case StopReason::diverged:
      return "the time stepping diverged";
    case StopReason::cloth_falls:
      return "the cloth falls freely: it touches the body nowhere";
    case StopReason::pieces_fall:
      return pieces_text(*this);
    case StopReason::caught_in_skin:
      return fmt::format("given up: the cloth is caught {:.0f} mm deep in a fold of the skin",
                         1e3 * depth);
    case StopReason::posture_too_long:
      return fmt::format("given up after {} iterations on the finest level", iterations);
    case StopReason::no_progress:
      return fmt::format(
          "given up: the net force has made no progress in {} iterations; at its lowest it was "
          "{:.2g} times the weight",
          iterations, residual);
    case StopReason::slides_down:
      return fmt::format(
          "the cloth slides down and nothing holds it: its middle has sunk by {:.2f} m in {} "
          "iterations that brought it no nearer to rest",
          sunk, iterations);
  }
  return {};
}

}  // namespace loosefit::drape

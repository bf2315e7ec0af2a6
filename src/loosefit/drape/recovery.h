#pragma once
#include <functional>
#include <string>
#include <vector>

namespace loosefit::drape {

struct ClothState;
struct SettlingTuning;

/// What is tried when something fails on the way from dressed to certified.
enum class RecoveryKind {
  wide_posture,
  shorter_step,
  settle_longer,
  free_cuts,
  renew_field,
  nearer_to_rest,
  leave_saddle,
  best_state,
  another_start
};

/// When it is asked whether something has failed.
enum class RecoveryPoint {
  dressed,        ///< the start was laid round the body, or found no room
  before_step,    ///< a step of the body is planned, the cloth would go along with it
  after_step,     ///< the cloth has settled after a step
  before_settle,  ///< the cloth is about to be settled
  at_rest,        ///< the finest level is near rest
  certified       ///< the certificate says that something is left
};

/// One way to save a drape: a row of the table in drape/recoveries.h.
struct Recovery {
  RecoveryKind kind;
  RecoveryPoint point;
  std::string name;     ///< for progress and reports: "shorter step of the body"
  std::string failure;  ///< what has failed
  std::string why;      ///< why the action may help
  /// How often it may be tried between two resets of its count (ClothState::attempts).
  std::function<int(const SettlingTuning&)> most_attempts;
  std::function<bool(ClothState&)> has_failed;
  std::function<void(ClothState&)> act;
};

/// The rows in the order in which they are tried.
using Recoveries = std::vector<Recovery>;

}  // namespace loosefit::drape

#pragma once
#include <cstdint>

#include "loosefit/base/types.h"
#include "loosefit/drape/settling_tuning.h"
#include "loosefit/solver/rest_tolerance.h"

namespace loosefit::drape {

/// How the particles are moved to equilibrium.
enum class IntegratorKind {
  semi_implicit_euler,  ///< the paper's: v += F/m dt, x += v dt
  implicit_euler,       ///< backward Euler dynamics
  quasi_static,         ///< pseudo-transient projected Newton; default
};

/// Options of one drape: dressing and settling, or following to another posture.
struct DrapeOptions {
  IntegratorKind integrator = IntegratorKind::quasi_static;
  /// ‖F‖₂/‖W‖₂ that is sought [–]. The certificate asks for kRestTolerance, or for this where it is
  /// looser.
  double residual_tolerance = solver::kRestTolerance;
  double gravity = kGravity;  ///< [m/s²]; the paper prints 9.8
  /// Wall seconds for the whole drape, times `drapes_at_once`; then its best state is taken.
  double time_budget = 600;
  /// Newton iterations for the whole drape, all levels and recoveries, time steps of implicit
  /// Euler, or a thousand times as many explicit steps; then its best state is taken. The longest
  /// of 1 400 drapes of random people and shirts took 3 931 (bench/history/robustness-*).
  int max_iterations = 5000;
  /// Drapes that share the threads with this one, it included: it has as many times its time.
  int drapes_at_once = 1;
  std::uint64_t seed = 1;         ///< of the start perturbation
  double start_perturbation = 0;  ///< rms shift of the dressed start [m]
  /// How the garment is pulled about once it is on: all of it shifted [m], and what lies on the
  /// trunk turned about a vertical axis [rad]. It then settles from there.
  Vec3 start_shift = Vec3::Zero();
  double start_twist = 0;
  SettlingTuning tuning = {};  ///< of the way to rest
};

}  // namespace loosefit::drape

#pragma once
#include <cstdint>

#include "loosefit/base/types.h"

namespace loosefit {

/// How the particles are moved to equilibrium.
enum class IntegratorKind {
  semi_implicit_euler,  ///< the paper's: v += F/m dt, x += v dt
  implicit_euler,       ///< backward Euler dynamics
  quasi_static,         ///< pseudo-transient projected Newton; default
};

/// Options of the dress and settle stages.
struct DrapeOptions {
  IntegratorKind integrator = IntegratorKind::quasi_static;
  double residual_tolerance = 1e-3;  ///< ‖F‖₂/‖W‖₂ [–]
  double gravity = 9.80665;          ///< m/s²; the paper prints 9.8
  double time_budget = 600;          ///< wall seconds for dress + settle; keeps the best state
  int max_iterations = 2000;         ///< Newton iterations or, times 1000, explicit steps
  int threads = 0;                   ///< 0 = all cores; results do not depend on it
  std::uint64_t seed = 1;            ///< of the start perturbation
  double start_perturbation = 0;     ///< rms shift of the dressed start [m]
  /// How the garment is pulled about once it is on: all of it shifted [m], and what lies on the
  /// trunk turned about a vertical axis [rad]. It then settles from there.
  Vec3 start_shift = Vec3::Zero();
  double start_twist = 0;
};

}  // namespace loosefit

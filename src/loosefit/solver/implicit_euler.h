#pragma once
#include <memory>

#include "loosefit/solver/integrator.h"
#include "loosefit/solver/solver_tuning.h"

namespace loosefit::solver {

/// Backward Euler dynamics as an incremental potential (Martin et al. 2011), fixed time step.
/// \throws InvalidInput for tuning that is out of range
std::unique_ptr<Integrator> make_implicit_euler(const ParticleSystem& system,
                                                const SolverTuning& tuning = {});

}  // namespace loosefit::solver

#pragma once
#include <string>
#include <vector>

#include "method.h"

namespace loosefit::bakeoff {

/// One look at the balance on the way.
struct Sample {
  double wall = 0, cpu = 0;  ///< since the start [s]
  int iterations = 0, factorisations = 0;
  double residual = 0;  ///< ‖F‖₂/‖W‖₂ with friction and contacts refreshed
};

struct Race {
  std::string reason;  ///< "converged", "time limit", "no further descent", "diverged"
  std::vector<Sample> samples;
  solver::SolverWork work;
};

struct RaceOptions {
  double tolerance = 1e-3;
  double first_dt = 0.5;   ///< [s]
  double cpu_limit = 120;  ///< [s]
};

/// Settles by the program's quasi-static integrator with the candidate inside, and records samples
/// on the way.
Race run_race(const solver::ParticleSystem& system, particles::VectorField& x,
              const Candidate& candidate, const RaceOptions& options);

}  // namespace loosefit::bakeoff

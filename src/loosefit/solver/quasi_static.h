#pragma once
#include <memory>

#include "loosefit/solver/descent_method.h"
#include "loosefit/solver/integrator.h"

namespace loosefit::solver {

/// Pseudo-transient continuation: implicit steps without velocity whose length grows as they
/// succeed, each minimised by Newton; the last ones are plain Newton on the force balance
/// (docs/theory/solver.md 2). Keeps what it learned of the matrix from one call to the next.
/// \throws InvalidInput for tuning that is out of range
std::unique_ptr<Integrator> make_quasi_static(const ParticleSystem& system,
                                              const SolverTuning& tuning = {});
/// The same with another method inside.
std::unique_ptr<Integrator> make_quasi_static(const ParticleSystem& system,
                                              std::unique_ptr<DescentMethod> method,
                                              const QuasiStaticTuning& tuning = {});

}  // namespace loosefit::solver

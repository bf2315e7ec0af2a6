#pragma once
#include <memory>

#include "loosefit/solver/integrator.h"
#include "loosefit/solver/solver_tuning.h"

namespace loosefit::solver {

/// The paper's scheme, v += F/m dt then x += v dt; the stable dt is estimated from the largest
/// eigenvalue of M⁻¹H. Kinetic damping (Cundall 1976): velocities are cleared when the kinetic
/// energy has passed a peak, which changes the way to the equilibrium, not the equilibrium.
/// \throws InvalidInput for tuning that is out of range
std::unique_ptr<Integrator> make_semi_implicit_euler(const ParticleSystem& system,
                                                     const SolverTuning& tuning = {});

/// One step of the paper's integrator; x and v are advanced in place. Harms et al. 2012,
/// section 2.1
void semi_implicit_euler_step(const ParticleSystem& system, particles::VectorField& x,
                              particles::VectorField& v, double dt);

}  // namespace loosefit::solver

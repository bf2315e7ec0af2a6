#pragma once
#include <functional>
#include <memory>
#include <string>

#include "loosefit/solver/particle_system.h"
#include "loosefit/solver/solver_work.h"

namespace loosefit {

/// When to stop settling, and what to tell on the way.
struct SettleOptions {
  double tolerance = 1e-3;    ///< ‖F‖₂/‖W‖₂ [–]
  int max_iterations = 1000;  ///< Newton iterations, or time steps of the dynamic integrators
  double max_move = 0.02;     ///< largest particle move per step, of all or of a region [m]
  double first_dt = 0.01;     ///< first pseudo-time step, or the time step of implicit Euler [s]
  /// Matrix of the Newton steps of the quasi-static integrator: changes the way and its cost, not
  /// the equilibrium. The full one takes over when the near one brings nothing any more.
  BendingTangent tangent = BendingTangent::plate;
  /// Called about once per iteration with (iteration, residual); true asks to stop.
  std::function<bool(int, double)> watch;
};

/// Why and where settling stopped.
struct SettleOutcome {
  enum class Reason { converged, iteration_limit, stopped, stuck, diverged } reason = Reason::stuck;
  double residual = 0, residual_max = 0;
  int worst_particle = -1;
  SolverWork work;
  std::string text() const;
};

/// Measures the static force balance at x (friction refreshed, no inertia, no viscosity) into the
/// outcome; true when settling is over because it is met or not a number, with the reason set.
bool check_convergence_at(const ParticleSystem& system, const VectorField& x, double tolerance,
                          SettleOutcome& outcome);
/// The same with the gradient at x known, friction refreshed by the caller.
bool check_convergence(const ParticleSystem& system, const VectorField& gradient, double tolerance,
                       SettleOutcome& outcome);

/// Moves particles until their forces balance. All kinds share one interface and one meaning of
/// rest: the static residual of all energies, friction included, without inertia and viscosity.
class Integrator {
 public:
  virtual ~Integrator() = default;
  virtual SettleOutcome settle(VectorField& x, const SettleOptions& options) = 0;
};

/// Pseudo-transient continuation: implicit steps without velocity whose length grows as they
/// succeed, each solved by Newton; the last ones are plain Newton on the force balance.
std::unique_ptr<Integrator> make_quasi_static(const ParticleSystem& system);
/// Backward Euler dynamics as an incremental potential (Martin et al. 2011), fixed time step.
std::unique_ptr<Integrator> make_implicit_euler(const ParticleSystem& system);
/// The paper's scheme, v += F/m dt then x += v dt; the stable dt is estimated from the largest
/// eigenvalue of M⁻¹H. Kinetic damping (Cundall 1976): velocities are cleared when the kinetic
/// energy has passed a peak, which changes the way to the equilibrium, not the equilibrium.
std::unique_ptr<Integrator> make_semi_implicit_euler(const ParticleSystem& system);

/// One step of the paper's integrator; x and v are advanced in place. Harms et al. 2012, section 2.1.
void semi_implicit_euler_step(const ParticleSystem& system, VectorField& x, VectorField& v,
                              double dt);

}  // namespace loosefit

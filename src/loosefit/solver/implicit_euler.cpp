#include "loosefit/solver/implicit_euler.h"

#include "loosefit/solver/newton.h"

namespace loosefit::solver {
namespace {

class ImplicitEuler : public Integrator {
 public:
  ImplicitEuler(const ParticleSystem& system, const SolverTuning& tuning)
      : system_(system), tuning_(tuning) {}

  SettleOutcome settle(particles::VectorField& x, const SettleOptions& options) override {
    Newton newton(system_, tuning_);
    newton.restart(options.max_move);
    system_.set_tangent(particles::BendingTangent::plate);
    system_.flatten_plates(x);
    SettleOutcome outcome;
    particles::VectorField v(x.size(), Vec3::Zero());
    const double dt = options.first_dt;
    for (int step = 0;; ++step) {
      outcome.work = newton.work();
      if (check_convergence_at(system_, x, options.goal(), outcome)) return outcome;
      if (step >= options.max_iterations) {
        outcome.reason = SettleOutcome::Reason::iteration_limit;
        return outcome;
      }
      if (options.watch && options.watch(step, outcome.residual)) {
        outcome.reason = SettleOutcome::Reason::stopped;
        return outcome;
      }
      // Free flight from here is the target of the inertia term.
      newton.begin_step(x, dt);
      const particles::VectorField start = x;
      particles::VectorField target(x.size());
      for (std::size_t i = 0; i < x.size(); ++i)
        target[i] = system_.is_held(static_cast<int>(i)) ? x[i] : Vec3(x[i] + dt * v[i]);
      // Newton steps until the force has fallen far enough.
      double first_force = -1;
      for (int k = 0; k < tuning_.implicit_euler.newton_per_step; ++k) {
        const auto n = newton.iterate(x, target, dt);
        if (first_force < 0) first_force = n.force;
        if (!n.moved || (k > 0 && n.force < tuning_.implicit_euler.step_reduction * first_force))
          break;
      }
      for (std::size_t i = 0; i < x.size(); ++i) v[i] = (x[i] - start[i]) / dt;
    }
  }

 private:
  const ParticleSystem& system_;
  SolverTuning tuning_;
};

}  // namespace

std::unique_ptr<Integrator> make_implicit_euler(const ParticleSystem& system,
                                                const SolverTuning& tuning) {
  tuning.validate();
  return std::make_unique<ImplicitEuler>(system, tuning);
}

}  // namespace loosefit::solver

#include "loosefit/solver/integrator.h"
#include "loosefit/solver/newton.h"

namespace loosefit {
namespace {

constexpr int kNewtonPerStep = 8;
constexpr double kStepReduction = 0.02;

class ImplicitEuler : public Integrator {
 public:
  explicit ImplicitEuler(const ParticleSystem& system) : system_(system) {}

  SettleOutcome settle(VectorField& x, const SettleOptions& options) override {
    Newton newton(system_, {options.max_move});
    system_.set_tangent(BendingTangent::plate);
    SettleOutcome outcome;
    VectorField v(x.size(), Vec3::Zero());
    const double dt = options.first_dt;
    for (int step = 0;; ++step) {
      outcome.work = newton.work();
      if (check_convergence_at(system_, x, options.tolerance, outcome)) return outcome;
      if (step >= options.max_iterations) {
        outcome.reason = SettleOutcome::Reason::iteration_limit;
        return outcome;
      }
      if (options.watch && options.watch(step, outcome.residual)) {
        outcome.reason = SettleOutcome::Reason::stopped;
        return outcome;
      }
      newton.begin_step(x, dt);
      const VectorField start = x;
      VectorField target(x.size());
      for (std::size_t i = 0; i < x.size(); ++i)
        target[i] = system_.is_held(static_cast<int>(i)) ? x[i] : Vec3(x[i] + dt * v[i]);
      double first_force = -1;
      for (int k = 0; k < kNewtonPerStep; ++k) {
        const auto n = newton.iterate(x, target, dt);
        if (first_force < 0) first_force = n.force;
        if (!n.moved || (k > 0 && n.force < kStepReduction * first_force)) break;
      }
      for (std::size_t i = 0; i < x.size(); ++i) v[i] = (x[i] - start[i]) / dt;
    }
  }

 private:
  const ParticleSystem& system_;
};

}  // namespace

std::unique_ptr<Integrator> make_implicit_euler(const ParticleSystem& system) {
  return std::make_unique<ImplicitEuler>(system);
}

}  // namespace loosefit

#include "loosefit/solver/quasi_static.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "loosefit/solver/newton.h"

namespace loosefit::solver {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The lowest residual so far, and the iteration of the last progress.
struct Progress {
  double lowest = kInfinity;
  int since = 0;
  void record(double residual, int iteration) {
    lowest = std::min(lowest, residual);
    since = iteration;
  }
};

/// Newton steps on one pseudo-step.
struct Round {
  bool moved = false;
  bool stopped = false;   ///< by the watch
  double last_share = 1;  ///< of the last Newton step; 0 if it failed
};

class QuasiStatic : public Integrator {
 public:
  QuasiStatic(const ParticleSystem& system, std::unique_ptr<DescentMethod> method,
              const QuasiStaticTuning& tuning)
      : system_(system), tuning_(tuning), method_(std::move(method)) {}

  SettleOutcome settle(particles::VectorField& x, const SettleOptions& options) override {
    system_.flatten_plates(x);
    start(x, options);
    SettleOutcome outcome;
    const auto end = [&](SettleOutcome::Reason reason) {
      outcome.reason = reason;
      return outcome;
    };
    while (true) {
      system_.flatten_plates(x);  // what something in the way had kept bent
      renew_friction(x);
      const bool is_over =
          check_convergence(system_, method_->gradient(x), options.goal(), outcome);
      outcome.work = method_->work();
      if (is_over) return outcome;
      if (outcome.work.iterations >= options.max_iterations)
        return end(SettleOutcome::Reason::iteration_limit);
      detect_cycle(outcome);
      choose_friction_interval(outcome);
      const Round round = minimise(x, options, outcome);
      if (round.stopped) return end(SettleOutcome::Reason::stopped);
      if (stalls_ == tuning_.stalls_to_plate) system_.set_tangent(particles::BendingTangent::plate);
      choose_pseudo_step(round);
      if (detect_stall(round)) return end(SettleOutcome::Reason::stuck);
    }
  }

 private:
  /// One step of the load history; everything after it iterates on its balance.
  void start(const particles::VectorField& x, const SettleOptions& options) {
    method_->restart(options.max_move);
    dt_ = options.first_dt;
    growth_ = tuning_.growth;
    newton_per_step_ = tuning_.newton_per_step;
    stalls_ = 0;
    static_progress_ = recent_progress_ = {};
    system_.set_tangent(options.tangent);
    method_->begin_step(x, dt_);
  }

  /// Contact sets, normal forces and anchors of the present place.
  void renew_friction(const particles::VectorField& x) { method_->begin_step(x, kInfinity); }

  /// Static steps that only send the cloth to and fro between two shapes: damped ones follow.
  void detect_cycle(const SettleOutcome& now) {
    const int iteration = now.work.iterations;
    const bool fell = now.residual < tuning_.progress * static_progress_.lowest;
    if (fell || dt_ <= tuning_.inertialess_dt) {
      static_progress_.record(now.residual, iteration);
    } else if (iteration - static_progress_.since > tuning_.cycle) {
      dt_ = tuning_.damped_dt;
      growth_ = std::max(tuning_.min_growth, std::sqrt(growth_));
    }
  }

  /// Without progress the cloth chases friction that changes under it: renew it less often.
  void choose_friction_interval(const SettleOutcome& now) {
    const int iteration = now.work.iterations;
    if (now.residual < tuning_.progress * recent_progress_.lowest) {
      recent_progress_.record(now.residual, iteration);
    } else if (iteration - recent_progress_.since > tuning_.no_progress) {
      newton_per_step_ = std::min(2 * newton_per_step_, tuning_.max_newton_per_step);
      recent_progress_.since = iteration;
    }
  }

  /// Newton steps on the energy of one pseudo-step from x.
  Round minimise(particles::VectorField& x, const SettleOptions& options,
                 const SettleOutcome& now) {
    Round round;
    const particles::VectorField start = x;
    const double dt = dt_ < tuning_.inertialess_dt ? dt_ : kInfinity;
    double first_force = -1;
    for (int k = 0; k < newton_per_step_; ++k) {
      if (options.watch && options.watch(method_->work().iterations, now.residual)) {
        round.stopped = true;
        return round;
      }
      const StepOutcome step = method_->iterate(x, start, dt);
      if (first_force < 0) first_force = step.force;
      round.last_share = step.moved ? step.share : 0;
      if (!step.moved) return round;
      round.moved = true;
      const bool reduced = k > 0 && step.force < tuning_.step_reduction * first_force;
      // A whole exact step has solved the step: what is left is friction and contacts.
      if (reduced || (step.exact && step.share > tuning_.whole)) return round;
    }
    return round;
  }

  /// Longer steps while Newton takes them whole, shorter ones when it has to be cut back.
  void choose_pseudo_step(const Round& round) {
    if (round.last_share > tuning_.whole)
      dt_ *= growth_;
    else if (round.last_share > tuning_.most)
      dt_ *= std::min(tuning_.slow_growth, growth_);
    else if (round.last_share < tuning_.cut_back)
      dt_ *= tuning_.shrink;
    dt_ = std::clamp(dt_, tuning_.min_dt, tuning_.max_dt);
    if (!round.moved) dt_ = std::max(tuning_.min_dt, tuning_.stall_shrink * dt_);
  }

  /// True when too many rounds in a row have not moved.
  bool detect_stall(const Round& round) {
    stalls_ = round.moved ? 0 : stalls_ + 1;
    return stalls_ > tuning_.max_stalls;
  }

  const ParticleSystem& system_;
  QuasiStaticTuning tuning_;
  std::unique_ptr<DescentMethod> method_;
  double dt_ = 0;             ///< pseudo-time step [s]
  double growth_ = 1;         ///< of dt_ after steps that were taken whole
  int newton_per_step_ = 0;   ///< until friction is renewed
  int stalls_ = 0;            ///< rounds in a row without a step
  Progress static_progress_;  ///< of the static iterations
  Progress recent_progress_;  ///< since friction was last renewed less often
};

}  // namespace

std::unique_ptr<Integrator> make_quasi_static(const ParticleSystem& system,
                                              const SolverTuning& tuning) {
  tuning.validate();
  return std::make_unique<QuasiStatic>(system, std::make_unique<Newton>(system, tuning),
                                       tuning.quasi_static);
}

std::unique_ptr<Integrator> make_quasi_static(const ParticleSystem& system,
                                              std::unique_ptr<DescentMethod> method,
                                              const QuasiStaticTuning& tuning) {
  return std::make_unique<QuasiStatic>(system, std::move(method), tuning);
}

}  // namespace loosefit::solver

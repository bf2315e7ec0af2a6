#include <algorithm>
#include <cmath>
#include <limits>

#include "loosefit/solver/integrator.h"
#include "loosefit/solver/newton.h"

namespace loosefit {

namespace {

/// Iterations, at most, before friction and contacts are refreshed: few while they are far from
/// what they will be, twice as many after each kNoProgress without kProgress of the residual, for
/// then friction is what the cloth chases.
constexpr int kNewtonPerStep = 3, kMostPerStep = 12, kNoProgress = 20;
constexpr double kStepReduction = 0.1;  ///< wanted drop of the force within one step
constexpr double kGrowth = 4;           ///< of pseudo-steps that are taken whole
/// Without such a fall of the residual in so many static iterations the cloth snaps to and fro
/// between two shapes: then damped steps of that length [s], which grow more slowly each time.
constexpr double kProgress = 0.7, kDampedDt = 0.1, kLeastGrowth = 1.2;
constexpr int kCycle = 60;
constexpr double kStaticDt = 1e3;  ///< pseudo-time [s] beyond which inertia is left out

/// The lowest residual so far and the iteration that it was found at.
struct Lowest {
  double residual = std::numeric_limits<double>::infinity();
  int at = 0;
  bool is_beaten_by(double other) const { return other < kProgress * residual; }
  void take(double other, int iteration) {
    residual = std::min(residual, other);
    at = iteration;
  }
};

class QuasiStatic : public Integrator {
 public:
  explicit QuasiStatic(const ParticleSystem& system) : system_(system), newton_(system) {}

  SettleOutcome settle(VectorField& x, const SettleOptions& options) override {
    newton_.restart({options.max_move});
    SettleOutcome outcome;
    const double infinity = std::numeric_limits<double>::infinity();
    double dt = options.first_dt;
    int stalls = 0;
    double growth = kGrowth;
    int newton_per_step = kNewtonPerStep;
    Lowest at_rest, lately;  // of the static iterations; since friction's rounds were made longer
    system_.set_tangent(options.tangent);
    // One step of the load history; what follows iterates on its balance.
    newton_.begin_step(x, dt);
    while (true) {
      newton_.begin_step(x, infinity);
      const bool rest = check_convergence(system_, newton_.gradient(x), options.tolerance, outcome);
      outcome.work = newton_.work();
      if (rest) return outcome;
      if (outcome.work.iterations >= options.max_iterations) {
        outcome.reason = SettleOutcome::Reason::iteration_limit;
        return outcome;
      }
      const int done = outcome.work.iterations;
      if (at_rest.is_beaten_by(outcome.residual) || dt <= kStaticDt) {
        at_rest.take(outcome.residual, done);
      } else if (done - at_rest.at > kCycle) {
        dt = kDampedDt;
        growth = std::max(kLeastGrowth, std::sqrt(growth));
      }
      if (lately.is_beaten_by(outcome.residual)) {
        lately.take(outcome.residual, done);
      } else if (done - lately.at > kNoProgress) {
        newton_per_step = std::min(2 * newton_per_step, kMostPerStep);
        lately.at = done;
      }
      const VectorField start = x;
      double first_force = -1, last_share = 1;
      bool moved = false;
      for (int k = 0; k < newton_per_step; ++k) {
        if (options.watch && options.watch(newton_.work().iterations, outcome.residual)) {
          outcome.reason = SettleOutcome::Reason::stopped;
          return outcome;
        }
        const auto step = newton_.iterate(x, start, dt < kStaticDt ? dt : infinity);
        if (first_force < 0) first_force = step.force;
        if (!step.moved) {
          last_share = 0;
          break;
        }
        moved = true;
        last_share = step.share;
        const bool reduced = k > 0 && step.force < kStepReduction * first_force;
        // Newton proper gets there at once: what is left then is friction and contacts.
        if (reduced || (step.exact && last_share > 0.9)) break;
      }
      // No way down with the near tangent: it may be too far from the truth here.
      if (stalls == 4) system_.set_tangent(BendingTangent::plate);
      // Longer steps while Newton takes them whole, shorter ones when it has to be cut back.
      if (last_share > 0.9)
        dt *= growth;
      else if (last_share > 0.4)
        dt *= std::min(1.5, growth);
      else if (last_share < 0.1)
        dt *= 0.4;
      dt = std::clamp(dt, 1e-4, 10 * kStaticDt);
      stalls = moved ? 0 : stalls + 1;
      if (!moved) dt = std::max(1e-4, 0.1 * dt);
      if (stalls > 8) {
        outcome.reason = SettleOutcome::Reason::stuck;
        return outcome;
      }
    }
  }

 private:
  const ParticleSystem& system_;
  Newton newton_;  ///< keeps what it learned of the matrix from one call to the next
};

}  // namespace

std::unique_ptr<Integrator> make_quasi_static(const ParticleSystem& system) {
  return std::make_unique<QuasiStatic>(system);
}

}  // namespace loosefit

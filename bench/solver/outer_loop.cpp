#include "outer_loop.h"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <limits>

#include "loosefit/solver/quasi_static.h"

namespace loosefit::bakeoff {
namespace {

double cpu_now() {
  timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

}  // namespace

Race run_race(const solver::ParticleSystem& system, particles::VectorField& x,
              const Candidate& candidate, const RaceOptions& options) {
  using Clock = std::chrono::steady_clock;
  const auto wall_start = Clock::now();
  const double cpu_start = cpu_now();
  auto owned = candidate.make(system);
  const solver::DescentMethod& method = *owned;
  Race race;
  const auto sample = [&](double residual) {
    const solver::SolverWork& work = method.work();
    const double wall = std::chrono::duration<double>(Clock::now() - wall_start).count();
    race.samples.push_back(
        {wall, cpu_now() - cpu_start, work.iterations, work.factorisations, residual});
  };

  solver::SettleOptions settle;
  settle.tolerance = options.tolerance;
  settle.max_iterations = std::numeric_limits<int>::max();
  settle.first_dt = options.first_dt;
  settle.tangent = particles::BendingTangent::hinge;
  // The residual changes where friction and contacts have just been renewed.
  settle.watch = [&](int, double residual) {
    if (race.samples.empty() || race.samples.back().residual != residual) sample(residual);
    return race.samples.back().cpu > options.cpu_limit;
  };
  solver::QuasiStaticTuning tuning;
  tuning.newton_per_step = candidate.per_step;
  tuning.max_newton_per_step = std::max(tuning.max_newton_per_step, candidate.per_step);
  const auto integrator = solver::make_quasi_static(system, std::move(owned), tuning);
  const solver::SettleOutcome outcome = integrator->settle(x, settle);
  sample(outcome.residual);
  race.work = method.work();
  race.reason =
      outcome.reason == solver::SettleOutcome::Reason::stopped ? "time limit" : outcome.text();
  return race;
}

}  // namespace loosefit::bakeoff

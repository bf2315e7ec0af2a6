#include "outer_loop.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <limits>

#include "loosefit/solver/integrator.h"

namespace loosefit::bakeoff {
namespace {

// As in solver/quasi_static.cpp.
constexpr double kStepReduction = 0.1;
constexpr int kSlowSteps = 30;
constexpr double kStaticDt = 1e3;

double cpu_now() {
  timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

}  // namespace

Race run_race(const ParticleSystem& system, VectorField& x, const Candidate& candidate,
              const RaceOptions& options) {
  using Clock = std::chrono::steady_clock;
  const auto wall_start = Clock::now();
  const double cpu_start = cpu_now(), infinity = std::numeric_limits<double>::infinity();
  const auto method = candidate.make(system);
  Race race;
  SettleOutcome outcome;
  double dt = options.first_dt;
  int stalls = 0, slow = 0;
  system.set_tangent(BendingTangent::hinge);
  method->begin_step(x, dt);
  while (true) {
    method->begin_step(x, infinity);
    const bool rest = check_convergence(system, method->gradient(x), options.tolerance, outcome);
    race.work = method->work();
    const double cpu = cpu_now() - cpu_start;
    race.samples.push_back({std::chrono::duration<double>(Clock::now() - wall_start).count(), cpu,
                            race.work.iterations, race.work.factorisations, outcome.residual});
    if (rest) {
      race.reason = outcome.text();
      return race;
    }
    if (cpu > options.cpu_limit) {
      race.reason = "time limit";
      return race;
    }
    const VectorField start = x;
    double first_force = -1, last_share = 1;
    bool moved = false, reduced = false;
    for (int k = 0; k < candidate.per_step; ++k) {
      const auto step = method->iterate(x, start, dt < kStaticDt ? dt : infinity);
      if (first_force < 0) first_force = step.force;
      if (!step.moved) {
        last_share = 0;
        break;
      }
      moved = true;
      last_share = step.share;
      reduced = k > 0 && step.force < kStepReduction * first_force;
      if (reduced || (step.exact && last_share > 0.9)) break;
    }
    slow = !reduced && last_share > 0.9 ? slow + 1 : 0;
    if (slow == kSlowSteps || stalls == 4) system.set_tangent(BendingTangent::plate);
    if (last_share > 0.9)
      dt *= 4;
    else if (last_share > 0.4)
      dt *= 1.5;
    else if (last_share < 0.1)
      dt *= 0.4;
    dt = std::clamp(dt, 1e-4, 10 * kStaticDt);
    stalls = moved ? 0 : stalls + 1;
    if (!moved) dt = std::max(1e-4, 0.1 * dt);
    if (stalls > 8) {
      race.reason = "no further descent";
      return race;
    }
  }
}

}  // namespace loosefit::bakeoff

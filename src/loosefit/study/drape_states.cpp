#include "loosefit/study/drape_states.h"

#include <fmt/format.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <chrono>

#include "loosefit/base/resources.h"
#include "loosefit/base/side_by_side.h"
#include "loosefit/body/named_postures.h"
#include "loosefit/flesh/soft_body.h"
#include "loosefit/study/case_layers.h"
#include "loosefit/study/case_stages.h"
#include "loosefit/study/wear_states.h"

namespace loosefit {
namespace {

using Clock = std::chrono::steady_clock;

/// Of the machine's memory, that states side by side may take.
constexpr double kMemoryShare = 0.5;

/// How many states are draped at a time: none takes more memory than the process has taken so far.
int states_at_once() {
  const auto threads =
      tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
  const double peak = peak_memory_mb(), all = physical_memory_mb();
  const double room = peak > 0 && all > 0 ? kMemoryShare * all / peak : 1;
  return std::max(1, static_cast<int>(std::min(room, static_cast<double>(threads))));
}

/// One state that is to be draped, with what it needs for itself.
struct Task {
  CaseState state;
  CaseBody body;
};

/// The tasks of one stage, draped side by side by `drape`, which is told its task and its progress.
class Tasks {
 public:
  explicit Tasks(CaseResult& result) : result_(result) {}

  void add(int posture, int donning) {
    Task& task = all_.emplace_back();
    task.state.posture = posture, task.state.donning = donning;
    task.state.name = result_.wear.postures[posture];
  }

  template <class Drape>
  std::vector<CaseState> carry_out(Progress& progress, const Drape& drape) {
    std::vector<SideJob> jobs;
    for (Task& task : all_)
      jobs.push_back({name_of(task.state), [&](Progress& own) {
                        const auto start = Clock::now();
                        task.body = another_caller(result_.body);
                        drape(task, own);
                        task.state.seconds =
                            std::chrono::duration<double>(Clock::now() - start).count();
                        check_worn(result_, task.state);
                      }});
    side_by_side(jobs, states_at_once(), progress);
    std::vector<CaseState> states;
    for (Task& task : all_) {
      if (result_.body.person) result_.body.person->learn(*task.body.person);
      auto& told = result_.body.warnings;
      for (const std::string& warning : task.body.warnings)
        if (std::find(told.begin(), told.end(), warning) == told.end()) told.push_back(warning);
      states.push_back(std::move(task.state));
    }
    return states;
  }

 private:
  std::string name_of(const CaseState& state) const {
    if (result_.wear.donnings.size() < 2) return state.name;
    return fmt::format("{} ({})", state.name, state.donning + 1);
  }

  CaseResult& result_;
  std::vector<Task> all_;
};

void follow(const CaseResult& result, const DrapeSession& session, Task& task, Progress& progress) {
  const BodyPath way = [&, to = named_posture(task.state.name)](double share) {
    if (share == 1) return *result.wear.bodies[task.state.posture];
    return task.body.pose(blend(result.scenario.body.posture, to, share));
  };
  take_drape(session.follow(way, progress), result, task.state);
}

/// The other postures of the first donning.
void drape_postures(CaseResult& result, const DrapeSession& first, Progress& progress) {
  progress.stage("postures");
  Tasks tasks(result);
  for (int p = 1; p < static_cast<int>(result.wear.postures.size()); ++p) tasks.add(p, 0);
  result.wear.states = tasks.carry_out(
      progress, [&](Task& task, Progress& own) { follow(result, first, task, own); });
}

/// The others, all put on before any of them follows: by then all know the same bodies.
void drape_donnings(CaseResult& result, Progress& progress) {
  progress.stage("donnings");
  const int donnings = static_cast<int>(result.wear.donnings.size());
  const int postures = static_cast<int>(result.wear.postures.size());
  std::vector<std::unique_ptr<DrapeSession>> sessions(donnings);
  Tasks in_reference(result), in_others(result);
  for (int k = 1; k < donnings; ++k) in_reference.add(0, k);
  std::vector<CaseState> put_on_again =
      in_reference.carry_out(progress, [&](Task& task, Progress& own) {
        const CaseDonning& how = result.wear.donnings[task.state.donning];
        DrapeOptions options = drape_options(result.scenario.simulation);
        options.start_shift = how.shift;
        options.start_twist = how.twist;
        auto& session = sessions[task.state.donning];
        session = std::make_unique<DrapeSession>(cloth_layers(result, how.friction), options, own);
        take_drape(put_on(*session, task.body), result, task.state);
      });
  for (const CaseState& state : put_on_again)
    for (int p = 1; p < postures && state.counts(); ++p) in_others.add(p, state.donning);
  std::vector<CaseState> followed = in_others.carry_out(progress, [&](Task& task, Progress& own) {
    follow(result, *sessions[task.state.donning], task, own);
  });
  auto next = followed.begin();
  for (CaseState& state : put_on_again) {
    const int donning = state.donning;
    const bool counts = state.counts();
    result.wear.states.push_back(std::move(state));
    for (int p = 1; p < postures; ++p) {
      if (counts) {
        result.wear.states.push_back(std::move(*next++));
        continue;
      }
      CaseState& left_out = result.wear.states.emplace_back();
      left_out.posture = p, left_out.donning = donning;
      left_out.name = result.wear.postures[p];
      left_out.left_out = "not tried: failed in the reference posture";
    }
  }
}

}  // namespace

void drape_states(CaseResult& result, DrapeSession& first, Progress& progress) {
  const bool settled = result.drape.certificate.settled();
  if (settled && result.scenario.postures.size() > 1) progress.stage("body");
  result.wear = plan_wear(result);
  if (result.wear.postures.empty() || !settled) return;
  if (result.wear.postures.size() > 1) drape_postures(result, first, progress);
  if (result.wear.donnings.size() > 1) drape_donnings(result, progress);
}

}  // namespace loosefit

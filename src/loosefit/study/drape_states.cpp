#include "loosefit/study/drape_states.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "loosefit/base/progress_part.h"
#include "loosefit/base/side_by_side.h"
#include "loosefit/body/named_postures.h"
#include "loosefit/flesh/soft_body.h"
#include "loosefit/study/case_layers.h"
#include "loosefit/study/case_stages.h"
#include "loosefit/study/check_worn.h"
#include "loosefit/study/wear_states.h"

namespace loosefit {
namespace {

using Clock = std::chrono::steady_clock;

/// One state that is to be draped.
struct Task {
  CaseState state;
  std::shared_ptr<DrapeSession> session;        ///< of its donning
  std::shared_ptr<const SoftBody> person = {};  ///< who has been in its posture, afterwards
  std::vector<std::string> warnings = {};
};

CaseState unmade(const CaseResult& result, int posture, int donning) {
  CaseState state;
  state.posture = posture, state.donning = donning;
  state.name = result.wear.postures[posture];
  return state;
}

std::string name_of(const CaseResult& result, const CaseState& state) {
  if (result.wear.donnings.size() < 2) return state.name;
  return fmt::format("{} ({})", state.name, state.donning + 1);
}

/// Carries out `drape(task, budget, progress)` for all tasks; `budget`: times the time that each
/// has, for it shares the threads with others.
template <class Drape>
void drape_all(const CaseResult& result, std::vector<Task>& tasks, int at_once, Progress& progress,
               const Drape& drape) {
  const double budget = std::max(1, std::min(at_once, static_cast<int>(tasks.size())));
  std::vector<SideJob> jobs;
  for (Task& task : tasks)
    jobs.push_back({name_of(result, task.state), [&](Progress& own) {
                      const auto start = Clock::now();
                      drape(task, budget, own);
                      task.state.seconds =
                          std::chrono::duration<double>(Clock::now() - start).count();
                      check_worn(result, task.state);
                    }});
  side_by_side(jobs, at_once, progress);
}

void follow(const CaseResult& result, Task& task, double budget, Progress& progress) {
  const int posture = task.state.posture;
  // Beside what putting on asked, whoever goes there knows that posture alone.
  auto person = std::make_shared<SoftBody>(*result.body.person);
  person->learn(*result.wear.wearers[posture]);
  const BodyPath way = [&, to = named_posture(task.state.name)](double share) {
    if (share == 1) return *result.wear.bodies[posture];
    return person->in(blend(result.scenario.body.posture, to, share));
  };
  take_drape(task.session->follow(way, progress, budget), result, task.state);
  task.session.reset();
  task.person = std::move(person);
}

void put_on_again(const CaseResult& result, Task& task, double budget, Progress& progress) {
  const CaseDonning& how = result.wear.donnings[task.state.donning];
  DrapeOptions options = drape_options(result.scenario.simulation);
  options.time_budget *= budget;
  options.start_shift = how.shift;
  options.start_twist = how.twist;
  CaseBody body = another_caller(result.body);
  task.session =
      std::make_shared<DrapeSession>(cloth_layers(result, how.friction), options, progress);
  take_drape(put_on(*task.session, body), result, task.state);
  task.warnings = warnings_since(result.body, body);
}

/// The other postures of the first donning.
void drape_postures(CaseResult& result, std::shared_ptr<DrapeSession> first, int at_once,
                    Progress& progress) {
  std::vector<Task> tasks;
  for (int p = 1; p < static_cast<int>(result.wear.postures.size()); ++p)
    tasks.push_back({unmade(result, p, 0), first});
  drape_all(result, tasks, at_once, progress,
            [&](Task& task, double budget, Progress& own) { follow(result, task, budget, own); });
  for (Task& task : tasks) {
    // Further donnings go the same way.
    result.wear.wearers[task.state.posture] = std::move(task.person);
    result.wear.states.push_back(std::move(task.state));
  }
}

/// Puts the garment on for each further donning; the tasks keep their sessions.
std::vector<Task> put_on_all(CaseResult& result, int at_once, Progress& progress) {
  std::vector<Task> tasks;
  for (int k = 1; k < static_cast<int>(result.wear.donnings.size()); ++k)
    tasks.push_back({unmade(result, 0, k), nullptr});
  drape_all(result, tasks, at_once, progress, [&](Task& task, double budget, Progress& own) {
    put_on_again(result, task, budget, own);
  });
  auto& told = result.body.warnings;
  for (const Task& task : tasks)
    for (const std::string& warning : task.warnings)
      if (std::find(told.begin(), told.end(), warning) == told.end()) told.push_back(warning);
  return tasks;
}

void drape_donnings(CaseResult& result, int at_once, Progress& progress) {
  const int postures = static_cast<int>(result.wear.postures.size());
  const double first = 1.0 / postures;
  ProgressPart putting_on(progress, 0, first), following(progress, first, 1 - first);
  std::vector<Task> put_on = put_on_all(result, at_once, putting_on), tasks;
  for (Task& task : put_on) {
    for (int p = 1; p < postures && task.state.counts(); ++p)
      tasks.push_back({unmade(result, p, task.state.donning), task.session});
    task.session.reset();
  }
  drape_all(result, tasks, at_once, following, [&](Task& task, double budget, Progress& own) {
    follow(result, task, budget, own);
    task.person.reset();
  });
  auto next = tasks.begin();
  for (Task& task : put_on) {
    const int donning = task.state.donning;
    const bool counts = task.state.counts();
    result.wear.states.push_back(std::move(task.state));
    for (int p = 1; p < postures; ++p) {
      if (counts) {
        result.wear.states.push_back(std::move((next++)->state));
        continue;
      }
      result.wear.states.push_back(unmade(result, p, donning));
      result.wear.states.back().left_out = "not tried: failed in the reference posture";
    }
  }
}

}  // namespace

void drape_states(CaseResult& result, std::shared_ptr<DrapeSession> first, int at_once,
                  Progress& progress) {
  result.wear = plan_wear(result.scenario);
  if (result.wear.postures.empty() || !result.drape.certificate.holds()) return;
  if (result.wear.postures.size() > 1) progress.stage("body");
  pose_wearers(result.body, result.wear, progress);
  if (result.wear.postures.size() > 1) {
    progress.stage("postures");
    drape_postures(result, std::move(first), at_once, progress);
  }
  if (result.wear.donnings.size() > 1) {
    progress.stage("donnings");
    drape_donnings(result, at_once, progress);
  }
}

}  // namespace loosefit

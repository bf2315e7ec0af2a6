#include "loosefit/pipeline/drape_states.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <functional>

#include "loosefit/base/progress_part.h"
#include "loosefit/body/named_postures.h"
#include "loosefit/flesh/soft_body.h"
#include "loosefit/pipeline/check_worn.h"
#include "loosefit/pipeline/drape_side_by_side.h"
#include "loosefit/pipeline/garment_layers.h"
#include "loosefit/pipeline/put_on_garments.h"
#include "loosefit/pipeline/simulation_options.h"
#include "loosefit/pipeline/wear_states.h"

namespace loosefit::pipeline {
namespace {

using Clock = std::chrono::steady_clock;

/// What all states are draped from.
struct Start {
  const CaseResult& reference;
  const CaseWear& wear;                     ///< postures, donnings and bodies
  const std::vector<PosedWearer>& wearers;  ///< per posture
  int at_once;

  const body::PosedBody& body_in(int posture) const {
    return posture == StateId::kReferencePosture ? reference.body.body : wear.bodies[posture];
  }
  CaseState undraped(const StateId& id) const {
    return {.id = id, .name = wear.postures[id.posture]};
  }
  std::string shown_name(const CaseState& state) const {
    return state_label(state, wear.donnings.size());
  }
};

/// One state that is to be draped, and what its draping leaves for other states.
struct Task {
  CaseState state;
  std::shared_ptr<drape::DrapeSession> session;        ///< of its donning
  std::shared_ptr<const flesh::SoftBody> person = {};  ///< who has been in its posture
  std::vector<std::string> warnings = {};
};

using DrapeTask = std::function<Task(Task, int sharing, Progress&)>;

/// The tasks with their states draped, timed and judged.
std::vector<Task> drape_all(const Start& start, std::vector<Task> tasks, Progress& progress,
                            const DrapeTask& drape) {
  std::vector<DrapeJob> jobs;
  for (Task& task : tasks) {
    const StateId id = task.state.id;
    jobs.push_back({start.shown_name(task.state),
                    [&](int sharing, Progress& own) {
                      const auto began = Clock::now();
                      task = drape(std::move(task), sharing, own);
                      task.state.seconds =
                          std::chrono::duration<double>(Clock::now() - began).count();
                      const body::PosedBody& body = start.body_in(task.state.id.posture);
                      task.state = check_worn(std::move(task.state), body, start.reference);
                    },
                    [&start, &task, id](const std::string& why) {
                      task = {start.undraped(id), nullptr};
                      task.state.left_out = "could not be draped: " + why;
                    }});
  }
  drape_side_by_side(jobs, start.at_once, progress);
  return tasks;
}

Task follow(const Start& start, Task task, int sharing, Progress& progress) {
  const scenario::Scenario& scenario = start.reference.scenario;
  const int posture = task.state.id.posture;
  // Beside what putting on asked, whoever goes there knows that posture alone.
  auto person = std::make_shared<flesh::SoftBody>(*start.reference.body.person);
  person->merge_cache(*start.wearers[posture].person);
  const body::BodyPath path = [&, to = body::named_posture(task.state.name)](double share) {
    if (share == 1) return start.body_in(posture);
    return person->in(body::blend(scenario.body.posture, to, share));
  };
  task.state.drapes = split_drape(task.session->follow(path, progress, sharing), scenario,
                                  start.reference.garments);
  task.session.reset();
  task.person = std::move(person);
  return task;
}

Task put_on_again(const Start& start, Task task, int sharing, Progress& progress) {
  const CaseResult& reference = start.reference;
  const CaseDonning& how = start.wear.donnings[task.state.id.donning];
  drape::DrapeOptions options = drape_options(reference.scenario.simulation);
  options.drapes_at_once = sharing;
  CaseBody body = clone_wearer(reference.body);
  PutOn again =
      put_on_garments(reference.scenario, reference.garments, body, how, options, progress);
  task.session = std::move(again.session);
  task.state.drapes = std::move(again.drapes);
  task.warnings = warnings_since(reference.body, body);
  return task;
}

/// The other postures of the first donning.
std::vector<Task> drape_postures(const Start& start, std::shared_ptr<drape::DrapeSession> first,
                                 Progress& progress) {
  std::vector<Task> tasks;
  for (const StateId& id : planned_states(start.wear))
    if (id.in_first_donning()) tasks.push_back({start.undraped(id), first});
  return drape_all(start, std::move(tasks), progress, [&](Task task, int sharing, Progress& own) {
    return follow(start, std::move(task), sharing, own);
  });
}

/// The reference posture of all further donnings; the tasks keep their sessions.
std::vector<Task> put_on_all(const Start& start, Progress& progress) {
  std::vector<Task> tasks;
  for (const StateId& id : planned_states(start.wear))
    if (id.in_reference_posture()) tasks.push_back({start.undraped(id), nullptr});
  return drape_all(start, std::move(tasks), progress, [&](Task task, int sharing, Progress& own) {
    return put_on_again(start, std::move(task), sharing, own);
  });
}

/// The other postures of those further donnings that count; takes their sessions.
std::vector<Task> follow_all(const Start& start, std::vector<Task>& put_on, Progress& progress) {
  std::vector<Task> tasks;
  for (Task& donning : put_on) {
    const auto session = std::move(donning.session);
    if (!donning.state.counts()) continue;
    for (const StateId& id : planned_states(start.wear))
      if (id.donning == donning.state.id.donning && !id.in_reference_posture())
        tasks.push_back({start.undraped(id), session});
  }
  return drape_all(start, std::move(tasks), progress, [&](Task task, int sharing, Progress& own) {
    Task done = follow(start, std::move(task), sharing, own);
    done.person.reset();  // nobody goes this way again
    return done;
  });
}

/// All further donnings: put on, then led through the postures.
std::vector<Task> drape_donnings(const Start& start, Progress& progress) {
  const double share = 1.0 / static_cast<double>(start.wear.postures.size());
  ProgressPart putting_on(progress, 0, share), following(progress, share, 1 - share);
  std::vector<Task> all = put_on_all(start, putting_on);
  std::vector<Task> followed = follow_all(start, all, following);
  std::move(followed.begin(), followed.end(), std::back_inserter(all));
  return all;
}

/// States and warnings of all tasks, in the order of planned_states.
CaseWear gathered(CaseWear wear, std::vector<Task> tasks) {
  for (const StateId& id : planned_states(wear)) {
    const auto task =
        std::find_if(tasks.begin(), tasks.end(), [&](const Task& t) { return t.state.id == id; });
    if (task != tasks.end()) {
      wear.states.push_back(std::move(task->state));
    } else {
      CaseState& state = wear.states.emplace_back();
      state.id = id, state.name = wear.postures[id.posture];
      state.left_out = "not tried: failed in the reference posture";
    }
  }
  for (const Task& task : tasks)
    for (const std::string& warning : task.warnings)
      if (std::ranges::find(wear.warnings, warning) == wear.warnings.end())
        wear.warnings.push_back(warning);
  return wear;
}

}  // namespace

CaseWear drape_states(const CaseResult& reference, std::shared_ptr<drape::DrapeSession> first,
                      int at_once, Progress& progress) {
  CaseWear wear = plan_wear(reference.scenario);
  if (wear.postures.empty() || !reference.certificate().holds()) return wear;
  const bool postures = wear.postures.size() > 1, donnings = wear.donnings.size() > 1;

  if (postures) progress.stage("body");
  std::vector<PosedWearer> wearers = pose_wearers(reference.body, wear.postures, progress);
  wear.bodies = bodies_of(wearers);
  const Start start{reference, wear, wearers, at_once};

  std::vector<Task> tasks;
  if (postures) {
    progress.stage("postures");
    tasks = drape_postures(start, std::move(first), progress);
    // Further donnings go the same way.
    for (Task& task : tasks)
      if (task.person) wearers[task.state.id.posture].person = std::move(task.person);
  }
  if (donnings) {
    progress.stage("donnings");
    std::vector<Task> further = drape_donnings(start, progress);
    std::move(further.begin(), further.end(), std::back_inserter(tasks));
  }
  return gathered(std::move(wear), std::move(tasks));
}

}  // namespace loosefit::pipeline

#include "loosefit/study/run_study.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <set>

#include "loosefit/base/text.h"
#include "loosefit/study/run_on_slurm.h"
#include "loosefit/study/store.h"

namespace loosefit::study {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Share done and time left, by the work that cases were estimated to be.
class Forecast {
 public:
  Forecast(const Plan& plan, const std::vector<std::string>& open)
      : work_(estimated_work(plan)), scores_(!plan.study.modalities.empty()) {
    for (const std::string& address : open) all_ += work_[address];
    count_ = static_cast<int>(open.size());
  }

  void finished(const CaseRecord& record, Progress& progress) {
    done_ += work_[record.address];
    ++ended_;
    trouble_ += scores_ ? !is_scored(record) : record.status != CaseStatus::done;
    std::string note = fmt::format("{} of {} cases", ended_, count_);
    if (trouble_ > 0) note += fmt::format(", {} without scores", trouble_);
    if (ended_ < count_)
      note += ", about " + duration_text(seconds_since(start_) * (all_ - done_) / done_) + " left";
    progress.update(all_ > 0 ? done_ / all_ : 1, note);
  }

 private:
  std::map<std::string, double> work_;
  bool scores_;  ///< some are asked for
  double all_ = 0, done_ = 0;
  int count_ = 0, ended_ = 0, trouble_ = 0;
  Clock::time_point start_ = Clock::now();
};

/// Results that another build of the program has made, of cases of this plan.
int of_other_builds(const StudyFolder& folder, const FolderPlan& plan) {
  std::set<std::string> addresses;
  for (const FolderCase& one : plan.cases) addresses.insert(one.address);
  return static_cast<int>(std::ranges::count_if(addresses, [&](const std::string& address) {
    const auto record = folder.record(address);
    return record && of_another_build(*record);
  }));
}

}  // namespace

std::string duration_text(double seconds) {
  if (seconds < 90) return fmt::format("{:.0f} s", seconds);
  const long minutes = std::lround(seconds / 60);
  if (minutes < 90) return fmt::format("{} min", minutes);
  return minutes % 60 == 0 ? fmt::format("{} h", minutes / 60)
                           : fmt::format("{} h {} min", minutes / 60, minutes % 60);
}

std::vector<std::string> longest_first(const Plan& plan, std::vector<std::string> addresses) {
  const std::map<std::string, double> work = estimated_work(plan);
  std::stable_sort(addresses.begin(), addresses.end(),
                   [&](const auto& a, const auto& b) { return work.at(a) > work.at(b); });
  return addresses;
}

StudyRun run_study(const Plan& plan, const StudyFolder& folder, const RunnerOptions& options,
                   bool slurm, bool retry_failed, Progress& progress, const RunHooks& hooks) {
  const auto start = Clock::now();
  const StudyLock lock(folder);
  progress.stage("plan");
  StudyRun run;
  folder.write_plan(plan, hooks.set_aside);
  const FolderPlan planned = folder.read_plan();
  if (retry_failed) folder.forget_failed(planned);
  collect(folder, planned);
  run.of_other_builds = of_other_builds(folder, planned);
  const std::vector<std::string> open = folder.state(planned).open;
  progress.stage("cases");
  {
    Store store(folder.database());
    Forecast forecast(plan, open);
    const ResultSeen seen = [&](const CaseRecord& record) {
      store.put(planned, record);
      ++run.ran;
      forecast.finished(record, progress);
    };
    run.given_up = slurm ? run_on_slurm(folder, open, options, seen, progress)
                         : run_here(folder, longest_first(plan, open), options, seen, progress);
  }
  run.state = folder.state(planned);
  run.seconds = seconds_since(start);
  hooks.at_end();
  return run;
}

}  // namespace loosefit::study

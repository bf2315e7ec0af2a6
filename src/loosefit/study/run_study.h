#pragma once
#include <functional>
#include <string>
#include <vector>

#include "loosefit/base/progress.h"
#include "loosefit/study/plan.h"
#include "loosefit/study/run_here.h"

namespace loosefit::study {

/// What a run of a study came to.
struct StudyRun {
  FolderState state;  ///< of the folder at its end
  int ran = 0;        ///< cases that ran now
  /// Earlier results that another build of the program made: an address knows its version only.
  int of_other_builds = 0;
  std::vector<GivenUp> given_up;
  double seconds = 0;
};

/// What is to be done while the folder is locked.
struct RunHooks {
  SetAside set_aside = [](const auto&) {};
  std::function<void()> at_end = [] {};  ///< once database and results are whole
};

/// `loosefit study run`: writes the plan into the folder, runs what of it has no result yet, and
/// brings the database up to it, case by case. \param slurm by job arrays, else here.
/// \throws InvalidInput when another runner works on the folder; IoError; Cancelled. In all cases
/// what has finished stays and is not run again.
StudyRun run_study(const Plan& plan, const StudyFolder& folder, const RunnerOptions& options,
                   bool slurm, bool retry_failed, Progress& progress, const RunHooks& hooks = {});

/// These cases, those with the most estimated work first, so that no worker is left with a long one
/// at the end (Graham 1969); in the order given where that is equal.
std::vector<std::string> longest_first(const Plan& plan, std::vector<std::string> addresses);

/// "3 min", "2 h 10 min", "40 s"
std::string duration_text(double seconds);

}  // namespace loosefit::study

#pragma once
#include <string>
#include <vector>

#include "loosefit/study/runner.h"

namespace loosefit::study {

/// Runs cases on this machine, each in a process of its own. A worker that crashes
/// (a fault of the program) is tried three times, after which the crash is the result of its case;
/// one that was killed from outside (also for want of memory) twenty times, after which the case
/// stays open. Results appear whole or not at all, so whatever ends this process, another run takes
/// up where it was. \throws IoError when a worker could not write or start, once the others have
/// ended; Cancelled.
std::vector<GivenUp> run_here(const StudyFolder& folder, const std::vector<std::string>& addresses,
                              const RunnerOptions& options, const ResultSeen& seen,
                              Progress& progress);

}  // namespace loosefit::study

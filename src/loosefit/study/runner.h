#pragma once
#include <functional>
#include <string>
#include <vector>

#include "loosefit/base/progress.h"
#include "loosefit/study/study_folder.h"

namespace loosefit::study {

/// How cases are run. Nothing here changes a result.
struct RunnerOptions {
  std::string program;  ///< that runs a case: PROGRAM study work DIR ADDRESS
  int jobs = 0;         ///< workers at a time; 0: one per core
  int threads = 1;      ///< of each
  bool keep_output = false;
  // Of the Slurm executor.
  std::string partition, time_limit;  ///< as sbatch takes them; empty: its own
  int bundle = 1;                     ///< cases per array task
  int memory_mb = 0;                  ///< per task; 0: that of the partition
};

/// Told of every result once it is on the disk.
using ResultSeen = std::function<void(const CaseRecord&)>;

/// Cases that did not come to an end, and why.
struct GivenUp {
  std::string address, why;
};

}  // namespace loosefit::study

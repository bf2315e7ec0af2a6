#pragma once
#include <string>
#include <vector>

#include "loosefit/study/runner.h"

namespace loosefit::study {

/// As run_here, by job arrays of Slurm (docs/studies.md 3). Bundles that died, or lost cases, are
/// submitted again while every third round yields a result. A job that an earlier runner has left
/// in the queue is waited for first. \throws IoError when Slurm cannot be asked; Cancelled, with
/// the job cancelled.
std::vector<GivenUp> run_on_slurm(const StudyFolder& folder,
                                  const std::vector<std::string>& addresses,
                                  const RunnerOptions& options, const ResultSeen& seen,
                                  Progress& progress);

/// Addresses of one line of a bundle file, as a task of an array has it.
std::vector<std::string> read_bundle(const std::string& file, int index);

}  // namespace loosefit::study

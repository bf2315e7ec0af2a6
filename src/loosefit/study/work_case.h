#pragma once
#include <string>

#include "loosefit/base/progress.h"
#include "loosefit/study/study_folder.h"

namespace loosefit::study {

/// How a worker runs a case.
struct WorkOptions {
  int threads = 1;
  /// Also write all files of `loosefit run` into the folder `output` of the case.
  bool keep_output = false;
};

/// Runs one case of a study in this process and writes its result.json; one that has its result
/// already does not run again. An error of the case is its result, not thrown. \throws IoError when
/// the result cannot be written, there are no body data, something of others stands where its
/// output goes, or an input is not what it was when the study was planned: nothing is recorded
/// then; Cancelled.
CaseRecord work_case(const StudyFolder& folder, const FolderPlan& plan, const std::string& address,
                     const WorkOptions& options, Progress& progress);

}  // namespace loosefit::study

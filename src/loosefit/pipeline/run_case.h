#pragma once
#include "loosefit/base/progress.h"
#include "loosefit/pipeline/case_result.h"

namespace loosefit::pipeline {

/// How a case is run, apart from what the scenario says.
struct RunOptions {
  bool allow_unsettled = false;  ///< make maps of a drape that did not settle
  bool only_drape = false;       ///< stop after settle, postures and donnings
};

/// The pipeline (docs/architecture.md): body, pattern, garment, dress, settle, maps, placement; the
/// report is made by the caller (report/run_into_folder.h). Does not throw when the drape fails to
/// settle: its certificate says why and the result is sealed. \throws InvalidInput, GeometryError,
/// IoError as the stages do; Cancelled.
CaseResult run_case(const scenario::Scenario& scenario, Progress& progress,
                    const RunOptions& options = {});

}  // namespace loosefit::pipeline

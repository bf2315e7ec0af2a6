#pragma once
#include "loosefit/base/progress.h"
#include "loosefit/pipeline/case_result.h"

namespace loosefit::pipeline {

/// Stages "body", "pattern" and "garment", which a run and a run that is read again have in common:
/// scenario (with the places of its boards), body, patterns and meshes of the result.
/// \throws InvalidInput, GeometryError, IoError as the stages do; InvalidInput also for sites that
/// cannot be found on this body and garment; Cancelled.
CaseResult prepare_case(const scenario::Scenario& scenario, Progress& progress);

}  // namespace loosefit::pipeline

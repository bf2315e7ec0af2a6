#pragma once
#include <string>

#include "loosefit/pipeline/case_result.h"

namespace loosefit::pipeline {

/// summary.json of a case as text; keys are stable and documented in docs/outputs.md. Numbers that
/// do not exist (a map without a value) are null.
std::string summary_json(const CaseResult& result);

}  // namespace loosefit::pipeline

#pragma once
#include <string>
#include <vector>

#include "loosefit/pipeline/case_result.h"

namespace loosefit::pipeline {

/// Everything the user should know of a case, in stage order.
std::vector<std::string> case_warnings(const CaseResult& result);

/// Which states do not count and why, one line each.
std::vector<std::string> state_warnings(const CaseResult& result);

}  // namespace loosefit::pipeline

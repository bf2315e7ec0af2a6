#pragma once
#include <string>

#include "loosefit/pipeline/case_result.h"

namespace loosefit::report {

/// The result of a case in a few lines for a terminal: warnings, certificate, fit, maps, timings.
/// Names that come from files are escaped (terminal_line).
std::string result_text(const pipeline::CaseResult& result);

}  // namespace loosefit::report

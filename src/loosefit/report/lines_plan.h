#pragma once
#include <string>

#include "loosefit/pipeline/case_result.h"

namespace loosefit::report {

/// Name of the plan in the folder of a run.
inline constexpr const char* kLinesPlan = "lines.svg";

/// Where lines run: the pattern at 1:1 as an SVG, seen from the outside, with every sensor that is
/// a line in a colour of its own, a dot at its begin, an arrow at its end, and its length; of lines
/// of least strain the other routes are dashed. Below stands a sentence per line. \throws
/// GeometryError for an invalid pattern.
std::string lines_plan_svg(const pipeline::CaseResult& result);

}  // namespace loosefit::report

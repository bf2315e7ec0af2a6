#pragma once
#include <string>
#include <vector>

#include "loosefit/io/pattern_svg.h"
#include "loosefit/pipeline/case_result.h"

namespace loosefit::report {

/// The lines of a case on one piece of a sheet, as SVG, and a sentence for each of them.
std::string lines_on_sheet(const pipeline::CaseResult& result, int panel,
                           const io::PanelOnSheet& sheet);
std::vector<std::string> line_sentences(const pipeline::CaseResult& result);

/// Where lines run: the pattern at 1:1 as an SVG, seen from the outside, with every sensor that is
/// a line in a colour of its own, a dot at its begin, an arrow at its end, and its length; of lines
/// of least strain the other routes are dashed. Below stands a sentence per line. \throws
/// GeometryError for an invalid pattern.
std::string lines_plan_svg(const pipeline::CaseResult& result);

}  // namespace loosefit::report

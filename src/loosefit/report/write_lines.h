#pragma once
#include <filesystem>

#include "loosefit/io/dxf/dxf_write.h"
#include "loosefit/pipeline/case_result.h"

namespace loosefit::report {

/// Files of sensors that are lines, in the folder of a run: the plan (lines_plan.h), the pattern
/// with their ways on the layer of marks for cutters and embroiderers (io/dxf/dxf_write.h), and
/// [[attachment]] cables for scenarios.
inline constexpr const char* kLinesPlan = "lines.svg";
inline constexpr const char* kLinesDxf = "lines.dxf";
inline constexpr const char* kLinesCables = "lines.toml";

/// The lines of a case on its pattern, a mark for each stretch in a piece.
std::vector<io::PatternMark> line_marks_of(const pipeline::CaseResult& result);

/// \throws IoError when a file cannot be written; GeometryError for an invalid pattern.
void write_lines(const std::filesystem::path& folder, const pipeline::CaseResult& result);

}  // namespace loosefit::report

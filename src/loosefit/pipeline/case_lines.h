#pragma once
#include <string>
#include <vector>

#include "loosefit/pipeline/case_result.h"

namespace loosefit::pipeline {

/// What the sites of the scenario that are lines (SiteSpec::line) see, in all states that count. A
/// line whose stops the garment does not cover, or to which no way leads that the scenario allows,
/// is left out. \throws InvalidInput as load_scorecard.
LineStage measure_lines(const CaseResult& mapped);

/// Before the long part: stops that no garment or body can have. \throws InvalidInput, key
/// `site[i].from`, `.via`, `.to` or `.keep_out`.
void check_lines(const CaseResult& prepared);

/// lines.csv: one row for each line and state.
std::string lines_csv(const CaseResult& result);

}  // namespace loosefit::pipeline

#pragma once
#include <string>
#include <vector>

#include "loosefit/pipeline/case_result.h"

namespace loosefit::pipeline {

/// What the sites of the scenario that are lines (SiteSpec::line) see, in all states that count.
/// \throws InvalidInput, key `site[i].from`, `.via`, `.to`, `.over` or `.course`.
std::vector<CaseLine> measure_lines(const CaseResult& mapped);

/// The same before the long part: stops that no garment or body can have. \throws as measure_lines.
void check_lines(const CaseResult& prepared);

/// lines.csv: one row for each line and state.
std::string lines_csv(const CaseResult& result);

}  // namespace loosefit::pipeline

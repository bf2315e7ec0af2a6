#pragma once
#include <vector>

#include "loosefit/pipeline/case_result.h"

namespace loosefit::report {

/// The style of every array that the studied garment has in any state, the maps of the reference
/// state first, with a colour range that fits all states of the case (maps/fit_range.h): its
/// pictures can be compared with each other.
std::vector<maps::MapArrayStyle> fitted_styles(const pipeline::CaseResult& result);

/// The maps of the studied garment in the reference state, with these ranges.
std::vector<maps::PerformanceMap> fitted_maps(const pipeline::CaseResult& result);

}  // namespace loosefit::report

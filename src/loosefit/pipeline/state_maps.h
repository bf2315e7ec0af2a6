#pragma once
#include <vector>

#include "loosefit/pipeline/case_result.h"

namespace loosefit::pipeline {

/// Stage "maps" of the studied garment in every state but the reference: `reference` is how it is
/// worn there. The maps of the scenario, in other postures than the reference followed by slip; the
/// pressure and the wrinkles. Empty for states that do not count.
std::vector<StateMaps> map_states(const CaseResult& draped, const maps::WornGarment& reference);

/// Greatest slip and calibrated orientation error per vertex over the postures of the first
/// donning; none without such postures. `states`: of map_states.
std::vector<CaseMap> posture_maps(const CaseResult& draped, const maps::WornGarment& reference,
                                  const std::vector<StateMaps>& states);

}  // namespace loosefit::pipeline

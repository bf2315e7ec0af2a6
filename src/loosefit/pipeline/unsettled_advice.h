#pragma once
#include <string>

#include "loosefit/drape/drape.h"
#include "loosefit/scenario/scenario.h"

namespace loosefit::pipeline {

/// What to try when a drape of this case is not settled: only keys that the case can have. A
/// person as scanned has no posture, a pattern file no fit, a garment of a size another size.
std::string unsettled_advice(const scenario::Scenario& scenario, const drape::Drape& drape);

}  // namespace loosefit::pipeline

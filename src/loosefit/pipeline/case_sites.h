#pragma once
#include "loosefit/pipeline/case_result.h"

namespace loosefit::pipeline {

/// Preset sites and those of the scenario on the studied garment, with what the maps say there;
/// none in other states. \throws InvalidInput naming a site whose panel or landmark is unknown.
SiteStage find_case_sites(const CaseResult& mapped);

/// Stage "placement": the same, and what these sensors, sewn where they are, meet in the reference
/// posture of the other donnings.
SiteStage make_sites(const CaseResult& mapped);

}  // namespace loosefit::pipeline

#pragma once
#include "loosefit/drape/drape.h"
#include "loosefit/pipeline/case_result.h"

namespace loosefit::pipeline {

/// Preset sites and those of the scenario on the studied garment, with what the maps say there;
/// none in other states. \throws InvalidInput naming a site whose panel or landmark is unknown.
SiteStage find_case_sites(const CaseResult& mapped);

/// Stage "placement": the same sites with the sensor of [ranking] where they state none of their
/// own, with what it meets (Site::samples), and what these sensors, sewn where they are, meet in
/// every other state that counts. \throws as find_case_sites, load_scorecard.
SiteStage make_sites(const CaseResult& mapped);

/// The sensors of a case in one drape of the studied garment by itself: maps and samples as of one
/// state, in the posture of the maps.
std::vector<placement::Site> sites_in_drape(const CaseResult& mapped, const drape::Drape& drape,
                                            const CaseMaps& maps, const body::PosedBody& body);

}  // namespace loosefit::pipeline

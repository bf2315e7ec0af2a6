#pragma once
#include "loosefit/placement/site_ranking.h"
#include "loosefit/study/case_result.h"

namespace loosefit {

/// Ranks sites by what one drape can say: one posture, one donning, so one sample and no interval.
/// Needs result.maps (worn garment and pressure). `wish.sites` are taken as they are; give
/// result.sites for those of the scenario. \throws InvalidInput as make_ranking.
RankingTable rank_case(const CaseResult& result, const RankingWish& wish);

}  // namespace loosefit

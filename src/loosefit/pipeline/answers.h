#pragma once
#include <vector>

#include "loosefit/pipeline/case_result.h"
#include "loosefit/placement/ranking_table.h"

namespace loosefit::pipeline {

/// One answer per sensor that was asked for: the best place of the ranking, then every [[site]]
/// that it holds, then every line. Where nothing was asked for, the usual four: an inertial sensor,
/// ECG, photoplethysmography and a strain sensor, each at the best of the preset places. `ranking`:
/// what [ranking] asks for, or null. None without maps. \throws as make_ranking
std::vector<Answer> make_answers(const CaseResult& result, const placement::RankingTable* ranking);

}  // namespace loosefit::pipeline

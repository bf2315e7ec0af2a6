#pragma once
#include <string>

#include "loosefit/pipeline/case_result.h"
#include "loosefit/placement/ranking_table.h"

namespace loosefit::report {

/// Where sensors are or should be, as a JSON object for the interactive page: `sites` in the order
/// of the report's table, `lines` with what of them lies in each triangle of the garment, and
/// `ranking` (null without one) with its places in the order of its table, their tolerances and the
/// clearances that the search kept. `table` may be null. Lengths in metres, angles in radians. The
/// keys are read by web/src/case_data.ts.
std::string places_json(const pipeline::CaseResult& result, const placement::RankingTable* table);

}  // namespace loosefit::report

#pragma once
#include "loosefit/pipeline/case_result.h"

namespace loosefit::pipeline {

/// Stage "maps" of a whole case: of all garments in the reference state and of the studied one in
/// all other states. Beside the maps of the studied garment also its slip and calibrated
/// orientation error over the postures of the first donning. \throws as make_maps.
MapStage map_case(const CaseResult& draped, bool allow_unsettled);

}  // namespace loosefit::pipeline

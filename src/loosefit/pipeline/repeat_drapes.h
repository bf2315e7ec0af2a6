#pragma once
#include <string>

#include "loosefit/base/progress.h"
#include "loosefit/pipeline/case_result.h"

namespace loosefit::pipeline {

/// Stage "repeats": drapes again from other starts, `at_once` side by side, as often as the
/// scenario's `repeats` asks beyond the first, and gathers the spread of every area mean and every
/// site value of the studied garment. A repeat that does not settle or is not worn is left out and
/// named in the warnings; there is no spread of fewer than two.
CaseRepeats repeat_drapes(const CaseResult& result, int at_once, Progress& progress);

/// The spreads of those maps and sites that `result`, an earlier output taken up again, has.
CaseRepeats known_repeats(const CaseResult& result);

/// Under which keys CaseRepeats::spread and summary.json keep spreads.
std::string map_spread_key(const std::string& array);
std::string site_spread_key(const std::string& site, const std::string& array);

}  // namespace loosefit::pipeline

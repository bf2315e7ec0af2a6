#pragma once
#include <string>
#include <vector>

#include "loosefit/pipeline/case_result.h"
#include "loosefit/placement/scorecard.h"
#include "loosefit/study/case_record.h"

namespace loosefit::study {

/// The criteria that a case can tell: those whose metrics need several postures or donnings stay
/// only when its scenario has several, whatever fails.
placement::Scorecard tellable(const placement::Scorecard& card, bool several_postures,
                              bool several_donnings);

/// Turns a case into what a study keeps of it. Each scorecard's sensor is held at every site of the
/// scenario (and preset, if they are reported), once per donning; a donning of which a posture does
/// not count gives no sample. Without maps (a sealed drape) there are no sites.
CaseRecord measure_case(const pipeline::CaseResult& result,
                        const std::vector<placement::Scorecard>& scorecards);

}  // namespace loosefit::study

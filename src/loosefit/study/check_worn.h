#pragma once
#include "loosefit/study/case_result.h"

namespace loosefit {

/// Asks whether the garments of result.drape are worn (drape/worn.h) and writes what is not into
/// the certificates of all of them.
void check_worn(CaseResult& result);

/// The same of a settled state, which is left out with the reasons when it is not worn; also when a
/// limb no longer goes through an opening of an unusual cut that it goes through in result.drape
/// (worn_alike).
void check_worn(const CaseResult& result, CaseState& state);

}  // namespace loosefit

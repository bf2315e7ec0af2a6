#pragma once
#include <string>
#include <vector>

#include "loosefit/pipeline/case_result.h"

namespace loosefit::pipeline {

/// Asks whether the garments of a scenario with these drapes, one each, are worn by `body`: as
/// drape/worn.h says, and not strained on half of their area so far beyond the range of their cards
/// that nobody would get into them (maps::kFarBeyond). The drapes with what is not in the
/// certificates of all of them.
std::vector<drape::Drape> check_worn(std::vector<drape::Drape> drapes,
                                     const std::vector<CaseGarment>& garments,
                                     const scenario::Scenario& scenario,
                                     const body::PosedBody& body);

/// The same of one more drape of the garments of `reference`, one each, on the body in its posture:
/// also not worn when a limb no longer goes through an opening of an unusual cut that it goes
/// through in the reference state (worn_alike).
std::vector<drape::Drape> check_worn(std::vector<drape::Drape> drapes, const body::PosedBody& body,
                                     const CaseResult& reference);

/// The same of a state of `reference`, when it is settled. It is left out with the reasons when it
/// is not worn.
CaseState check_worn(CaseState state, const body::PosedBody& body, const CaseResult& reference);

/// What was asked of garments that are worn, as a phrase: all that drape/worn.h asks, or what of it
/// could be asked of these openings and this body.
std::string what_worn_says(const CaseResult& result);

}  // namespace loosefit::pipeline

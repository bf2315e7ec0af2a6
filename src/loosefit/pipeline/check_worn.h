#pragma once
#include <string>
#include <vector>

#include "loosefit/pipeline/case_result.h"

namespace loosefit::pipeline {

/// Asks whether the garments of a scenario with these drapes, one each, are worn by `body`: as
/// drape/worn.h says, and strained at no opening (drape/rims.h) and in no region of the body
/// (maps::torn_regions) so far that they would tear or nobody would get into them. The drapes with
/// what is not in the certificates of all of them.
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

/// Whether the wearer gets into all garments as they are cut (drape/putting_on.h), in any posture
/// of `body`. That one needs a fastening does not make it unworn: patterns do not tell fastenings.
PuttingOn judge_putting_on(const std::vector<CaseGarment>& garments,
                           const scenario::Scenario& scenario, const body::PosedBody& body);

/// Takes a "yes" back, with the reasons, where the drape of a garment is torn or its neck went over
/// no head: girths alone do not tell what that drape shows.
void doubt_putting_on(CaseResult& result);

/// "yes", "not without a fastening: …" or "not judged: …" with the reasons; "not asked".
std::string putting_on_verdict(const PuttingOn& putting_on);

/// What was asked of garments that are worn, as a phrase: all that drape/worn.h asks, or what of it
/// could be asked of these openings and this body.
std::string what_worn_says(const CaseResult& result);

}  // namespace loosefit::pipeline

#pragma once
#include <memory>

#include "loosefit/base/progress.h"
#include "loosefit/drape/drape_session.h"
#include "loosefit/study/case_result.h"

namespace loosefit {

/// Stages "postures" and "donnings": the garment of `first`, which has been put on and gave
/// result.drape, follows its wearer through the other postures; then each further donning puts it
/// on from its own start and goes through all postures. States need nothing from each other, so
/// they are draped side by side, `at_once` at a time, with as many times the time budget each;
/// unless that ends one, the bits do not depend on how many. Does not throw when one fails to
/// settle: that state says why and does not count. Nothing happens when result.drape itself is not
/// settled and worn.
void drape_states(CaseResult& result, std::shared_ptr<DrapeSession> first, int at_once,
                  Progress& progress);

}  // namespace loosefit

#pragma once
#include <memory>

#include "loosefit/base/progress.h"
#include "loosefit/drape/drape_session.h"
#include "loosefit/pipeline/case_result.h"

namespace loosefit::pipeline {

/// Stages "postures" and "donnings" of a case whose reference state is draped: the garments, which
/// have been put on in `first`, follow their wearer through the other postures; then each further
/// donning puts them on from its own start and goes through all postures. States need nothing from
/// each other, so they are draped side by side, `at_once` at a time; unless the time budget ends
/// one, the bits do not depend on how many. Does not throw when one fails to settle or cannot be
/// draped: that state says why and does not count. Without states when the reference state is not settled and worn.
CaseWear drape_states(const CaseResult& reference, std::shared_ptr<drape::DrapeSession> first,
                      int at_once, Progress& progress);

}  // namespace loosefit::pipeline

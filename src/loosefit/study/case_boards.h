#pragma once
#include <vector>

#include "loosefit/base/progress.h"
#include "loosefit/study/case_result.h"

namespace loosefit {

/// The attachments of a scenario and the boards of its sites.
/// \throws InvalidInput as site_boards.
std::vector<Attachment> all_attachments(const Scenario& scenario);

/// Gives every site with a board a place in the pattern, which must be known before the garment
/// with its boards can be made. Where the scenario names a landmark or an anatomical address, the
/// bare garment (its own attachments only) is draped on its coarsest mesh to a residual of 1 %, and
/// the place found on that becomes `panel` and `at` of the site in result.scenario. Needs body and
/// pattern. \throws InvalidInput as find_sites.
void place_boards(CaseResult& result, Progress& progress);

/// Adds a warning for every board that place_boards sewed on and whose skin partner in the final
/// drape is more than 15 mm from where it was wanted.
void warn_of_moved_boards(CaseResult& result);

}  // namespace loosefit

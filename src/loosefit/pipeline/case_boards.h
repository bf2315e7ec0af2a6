#pragma once
#include <string>
#include <vector>

#include "loosefit/base/progress.h"
#include "loosefit/pipeline/case_result.h"

namespace loosefit::pipeline {

/// The attachments of a scenario and the boards of its sites.
/// \throws InvalidInput as site_boards.
std::vector<garment::Attachment> all_attachments(const scenario::Scenario& scenario);

/// The sites of the scenario, each one with a board with its place in the pattern, which must be
/// known before the garment with its boards can be meshed. Where the scenario names a landmark or
/// an anatomical address, the bare garment (its own attachments only) is draped on its coarsest
/// mesh to a residual of 1 %, and the place found on that becomes `panel` and `at` of the site.
/// \throws InvalidInput as find_sites.
std::vector<placement::SiteSpec> place_boards(const scenario::Scenario& scenario,
                                              const CaseBody& body,
                                              const std::vector<CasePattern>& patterns,
                                              Progress& progress);

/// One line for every board that place_boards sewed on and whose skin partner in the final drape is
/// more than 15 mm from the skin that the scenario names.
std::vector<std::string> moved_board_warnings(const CaseResult& result);

}  // namespace loosefit::pipeline

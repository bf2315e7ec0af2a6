#pragma once
#include <string>
#include <vector>

#include "loosefit/base/progress.h"
#include "loosefit/pipeline/case_result.h"

namespace loosefit::pipeline {

/// What is sewn onto the studied garment, and the sites with their places in the pattern.
struct SewnParts {
  /// Those of the scenario; each with a board, and each line that is a part of the garment
  /// (LineSpec::is_sewn_part), has its place in the pattern.
  std::vector<placement::SiteSpec> sites;
  /// Of the scenario, then of boards, then of lines: a cable for each piece that one runs over.
  std::vector<garment::Attachment> attachments;
};

/// What must be known before the garment can be meshed with what is sewn on. Where the scenario
/// names a landmark or an anatomical address, the bare garment (the scenario's own attachments
/// only) is draped on its coarsest mesh to a residual of 1 %, and the place found on that becomes
/// the place in the pattern. A place in the pattern with a shift needs no drape.
/// \throws InvalidInput as find_sites, without_shift, site_boards and CourseFinder::stops.
SewnParts place_sewn_parts(const scenario::Scenario& scenario, const CaseBody& body,
                           const std::vector<CasePattern>& patterns, Progress& progress);

/// A line as cables, one for each stretch of it in a piece of the pattern, in its order; "name 1 of
/// 3" where there are several.
std::vector<garment::Attachment> cables_along(const std::string& name,
                                              const placement::LineSpec& line,
                                              const lines::LineCourse& course,
                                              const garment::Garment& mesh,
                                              const pattern::Pattern& pattern);

/// One line for every board that place_sewn_parts sewed on and whose skin partner in the final
/// drape is more than 15 mm from the skin that the scenario names.
std::vector<std::string> moved_board_warnings(const CaseResult& result);

/// One line for every board that bends with the cloth because raw figures say so: up to version 0.3
/// all boards did.
std::vector<std::string> flexible_board_notes(const scenario::Scenario& scenario);

}  // namespace loosefit::pipeline

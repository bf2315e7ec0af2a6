#pragma once
#include <filesystem>
#include <vector>

#include "loosefit/base/progress.h"
#include "loosefit/render/render_pictures.h"
#include "loosefit/report/case_forms.h"

namespace loosefit::report {

/// Draws a case into its folder, as [output] of its scenario asks: every map of the studied garment
/// into maps/, those of the garments under it into their folders, plain pictures of the postures of
/// the first donning into theirs. Returns those of the studied garment in the reference state.
/// \throws NoScreen before anything is written; as render_pictures; Cancelled.
std::vector<render::Picture> draw_case(const std::filesystem::path& folder,
                                       const pipeline::CaseResult& result, const CaseForms& forms,
                                       Progress& progress);

/// Names of the files that draw_case may write for a scenario, relative to its folder.
std::vector<std::filesystem::path> planned_pictures(const scenario::Scenario& scenario);

/// The lines of a case on its garment in a drape.
std::vector<render::LineMark> marked_lines(const pipeline::CaseResult& result,
                                           const std::vector<Vec3>& positions);

}  // namespace loosefit::report

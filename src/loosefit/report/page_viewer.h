#pragma once
#include <string>

#include "loosefit/placement/ranking_table.h"
#include "loosefit/report/case_forms.h"

namespace loosefit::report {

/// Whether this program can write interactive pages (page_bundle.h).
bool has_viewer();

/// Head part: the style of the viewer, and a script that finds out whether the browser can draw it
/// (class `webgl` of the root element), so that nothing jumps once the page is read.
std::string viewer_head();
/// Where the viewer will be. A case of which nothing can be drawn has none.
std::string viewer_section(const pipeline::CaseResult& result);
/// Foot of the page: the case, its arrays and the script.
std::string viewer_data(const pipeline::CaseResult& result, const CaseForms& forms,
                        const placement::RankingTable* ranking);

}  // namespace loosefit::report

#pragma once
#include <string>

#include "loosefit/pattern/pattern.h"
#include "loosefit/pipeline/case_result.h"
#include "loosefit/placement/ranking_table.h"

namespace loosefit::report {

/// Where to sew: the pattern at 1:1 as an SVG, seen from the outside, with every site of a ranking
/// that scores above 0: outline of the sensor, arrow along its axis, ellipse of the tolerance
/// (where its centre may lie), and the distances from its centre to two edges of the piece that do
/// not run alike. Places where nothing may be sewn, near seams and hems and in keep-out zones, are
/// shaded. Sites that fail or are not rated are only crosses. Below stand scale, signs, and a line
/// per recommended site with both addresses. With `lines`, a case of that pattern, its lines stand
/// on the sheet too (lines_plan.h). \throws GeometryError for an invalid pattern.
std::string sewing_plan_svg(const placement::RankingTable& table, const pattern::Pattern& pattern,
                            const pipeline::CaseResult* lines = nullptr);

}  // namespace loosefit::report

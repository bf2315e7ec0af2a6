#pragma once
#include <string>
#include <vector>

#include "loosefit/pipeline/case_result.h"
#include "loosefit/placement/ranking_table.h"
#include "loosefit/render/render_pictures.h"

namespace loosefit::report {

// Each returns one part of the report as HTML, empty when the result has nothing for it.

/// Headline and a sentence on who wears what.
std::string headline_section(const pipeline::CaseResult& result);
/// What to sew where and what to expect: CaseResult::answers, each with its piece of the pattern.
std::string answer_section(const pipeline::CaseResult& result);
/// All warnings: folded away below the answers, open for a drape that is not to be relied on.
std::string warning_section(const pipeline::CaseResult& result);
/// Settled or sealed, with the numbers that say so and the way the residual fell.
std::string certificate_section(const pipeline::CaseResult& result);
/// Why the drape is not settled: what is out of balance, by which forces, and what cuts.
std::string unsettled_section(const pipeline::CaseResult& result);
/// One row of pictures per view, embedded.
std::string picture_section(const pipeline::CaseResult& result,
                            const std::vector<render::Picture>& pictures);
/// What each map means: equation, source and mesh, so that a number can be traced.
std::string definition_section(const pipeline::CaseResult& result);
/// Statistics per map, then medians per body region.
std::string map_section(const pipeline::CaseResult& result);
/// Contact pressure by both estimates, over the garment and per region, with their disagreement.
std::string pressure_section(const pipeline::CaseResult& result);
/// Whether a garment that is meant to hang hangs: its force over its weight, by limb, contact, ease
/// as asked and as cut, and strain against what the cloth was measured over.
std::string fit_check_section(const pipeline::CaseResult& result);
/// Slope, direction and coherence of the folds per region.
std::string wrinkle_section(const pipeline::CaseResult& result);
/// The quantities of the maps at every site.
std::string site_section(const pipeline::CaseResult& result);
/// What every line sees, its routes, and its curves against swept joints; empty without lines.
std::string line_section(const pipeline::CaseResult& result);
/// How maps and sites vary over drapes from other starts; empty without repeats.
std::string repeat_section(const pipeline::CaseResult& result);
/// What is worn over each other, the innermost first; empty for one garment.
std::string layer_section(const pipeline::CaseResult& result);
/// One row per posture and donning: whether it settled, how the garment slipped, what it took.
std::string wear_section(const pipeline::CaseResult& result);
/// The ranked sites: scores with their intervals as a chart, then reasons; empty without a table.
std::string ranking_section(const placement::RankingTable* table);
/// Fit per level, body asked and measured.
std::string fit_section(const pipeline::CaseResult& result);
/// Cloth and garment, stage timings, versions, resolved scenario.
std::string provenance_section(const pipeline::CaseResult& result);

}  // namespace loosefit::report

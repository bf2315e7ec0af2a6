#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "loosefit/pattern/pattern.h"
#include "loosefit/pipeline/case_result.h"
#include "loosefit/placement/ranking_table.h"

namespace loosefit::report {

/// One sentence when no site passes, with the one that comes nearest, or when none can be rated;
/// else empty.
std::string ranking_verdict(const placement::RankingTable& table);

/// "2=" of a shared rank; "-" of a site that is not rated or fails altogether.
std::string rank_text(const placement::RankedSite& site, const placement::Ranking& ranking);

/// For the terminal: one line per site with scores, intervals, rank interval and the limiting
/// reason; notes below. "2=" is a rank that is shared. An unrated site shows the bound of its
/// score.
std::string ranking_text(const placement::RankingTable& table);

/// What the reader of a ranking should know beside its rows: those of the ranking, criteria that
/// were not looked at, those of the table.
std::vector<std::string> ranking_notes(const placement::RankingTable& table);

/// RFC 4180, one row per site, best first: the columns are explained in docs/outputs.md. Metrics,
/// derived ones included, are medians over the samples. Lengths with _mm are millimetres.
std::string ranking_csv(const placement::RankingTable& table);

/// The same with every sample of every metric.
std::string ranking_json(const placement::RankingTable& table);

/// The files that write_ranking makes for a scorecard of this name.
std::vector<std::string> ranking_files(const std::string& scorecard);

/// Writes ranking-NAME.csv, ranking-NAME.json and sewing-plan-NAME.svg, NAME that of the scorecard,
/// so that the rankings for several sensors lie beside each other. `lines`: as sewing_plan_svg.
/// \throws IoError.
void write_ranking(const std::filesystem::path& folder, const placement::RankingTable& table,
                   const pattern::Pattern& pattern, const pipeline::CaseResult* lines = nullptr);

}  // namespace loosefit::report

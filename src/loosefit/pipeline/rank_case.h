#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "loosefit/pipeline/case_result.h"
#include "loosefit/placement/site_ranking.h"

namespace loosefit::pipeline {

/// One run of those over which sites are ranked.
struct RankedRun {
  std::string name;  ///< of its folder
  const CaseResult* result = nullptr;
};

/// What the section [ranking] of a scenario asks for. \throws as load_scorecard.
placement::RankingWish ranking_wish(const scenario::ScenarioRanking& asked, std::uint64_t seed);

/// Whether two patterns have the same pieces: names, and outlines to half a millimetre.
bool same_pieces(const pattern::Pattern& a, const pattern::Pattern& b);

/// Ranks sites over one or several runs, each donning of each a sample. Postures and donnings
/// that do not count are named in the notes. Needs result.maps (worn garment and pressure) of every
/// run. `with_sites` ranks the sites of the first run's scenario, and its presets where they are
/// reported: in garments with the same pieces the sensors stay where they are sewn in the first;
/// otherwise each run finds its own by their names, and what some run lacks is left out and noted.
/// What a garment does not cover is listed apart and not ranked.
/// \throws InvalidInput as make_ranking; without runs; for wished sites that a run lacks.
placement::RankingTable rank_cases(const std::vector<RankedRun>& runs,
                                   const placement::RankingWish& wish, bool with_sites);

}  // namespace loosefit::pipeline

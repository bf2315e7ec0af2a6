#pragma once
#include <functional>
#include <string>
#include <vector>

#include "loosefit/placement/ranking_table.h"
#include "loosefit/placement/ranking_wearers.h"
#include "loosefit/placement/site_search.h"
#include "loosefit/placement/sites.h"

namespace loosefit::placement {

/// What is to be ranked.
struct RankingWish {
  Scorecard scorecard;
  std::vector<Site> sites;                    ///< given places, on the first wearer
  std::vector<UncoveredSite> uncovered = {};  ///< given ones that its garment does not cover
  int best = 0;                               ///< search for so many more
  SearchConstraints constraints;              ///< without regions: those of the scorecard
  SearchOptions search;                       ///< its `best` is set from above
  RankOptions rank;
  /// Judge by the criteria that the states can tell when some need more postures or donnings; the
  /// scores are then upper bounds and the table says so.
  bool partial = false;
  bool tolerances = true;  ///< how far given sites may be off; costs most of the time
  std::function<void(double)> progress = {};  ///< of the search: SearchField::progress
};

/// Ranks the given sites together with the best places found by search_sites (named best_1, …).
/// Places that cover no skin on some wearer are not ranked but listed apart. Every donning of every
/// wearer is one sample. A found place is that of one garment in the same
/// cut for all wearers; its direction is that on the first. Every site with a score above 0 has a
/// tolerance, but for girths and where wearers have sites of their own.
/// \throws InvalidInput as search_sites and rank_sites; without wearers; for a search with a girth
/// line, or over wearers with sites of their own; for a place that a wearer's garment lacks.
RankingTable make_ranking(const std::vector<RankingWearer>& wearers, const RankingWish& wish);

/// The same for one wearer.
RankingTable make_ranking(const RankingGround& ground, const RankingWish& wish);

}  // namespace loosefit::placement

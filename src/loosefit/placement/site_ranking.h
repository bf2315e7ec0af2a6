#pragma once
#include <functional>
#include <string>
#include <vector>

#include "loosefit/placement/ranking_table.h"
#include "loosefit/placement/segment_direction.h"
#include "loosefit/placement/site_metrics.h"
#include "loosefit/placement/site_search.h"
#include "loosefit/placement/sites.h"

namespace loosefit {

/// A garment in its reference posture, and the meter that knows all postures and donnings. Only
/// referred to.
struct RankingGround {
  const Garment& garment;
  const std::vector<Vec3>& positions;
  const Body& body;
  const WornGarment& worn;
  const SiteMeter& meter;
};

/// What is to be ranked.
struct RankingWish {
  Scorecard scorecard;
  std::vector<Site> sites;        ///< given places
  int best = 0;                   ///< search for so many more
  SearchConstraints constraints;  ///< without regions: those of the scorecard
  SearchOptions search;           ///< its `best` is set from above
  RankOptions rank;
  /// Judge by the criteria that the states can tell when some need more postures or donnings; the
  /// scores are then upper bounds and the table says so.
  bool partial = false;
  std::function<void(double)> progress = {};  ///< of the search: SearchField::progress
};

/// The given sites with the scorecard's sensor in place of theirs, described anew: its footprint,
/// its axis along or around the segment (a stated angle other than 0 is kept). A site that was
/// asked for by name and states a footprint of its own keeps it with its angle. Girth lines stay
/// when the scorecard's sensor is a line, and are left out, named in `left_out`, when it is not.
std::vector<Site> sites_with_sensor(const RankingGround& ground, const std::vector<Site>& sites,
                                    const Scorecard& scorecard, std::vector<std::string>& left_out);

/// Ranks the given sites together with the best places found by search_sites (named best_1, …).
/// Every donning of the meter is one sample. \throws InvalidInput as search_sites and rank_sites,
/// and for a search with a girth line.
RankingTable make_ranking(const RankingGround& ground, const RankingWish& wish);

}  // namespace loosefit

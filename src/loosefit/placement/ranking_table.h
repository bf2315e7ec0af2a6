#pragma once
#include <optional>
#include <string>
#include <vector>

#include "loosefit/placement/rank.h"
#include "loosefit/placement/tolerance.h"

namespace loosefit {

/// Where a ranked site lies.
struct RankedPlace {
  std::string region, panel;
  Vec2 at = Vec2::Zero();        ///< in the pattern [m]
  Vec3 position = Vec3::Zero();  ///< as worn [m]
  double angle = 0;              ///< of the sensor's axis in the pattern [rad] (FootprintShape)
  std::string body_address;      ///< anatomical, in words; may be empty
  std::optional<Tolerance> tolerance;
};

/// A ranking with all that its readers want beside it.
struct RankingTable {
  Scorecard scorecard;
  Ranking ranking;
  std::vector<SiteSamples> sites;   ///< what was ranked: RankedSite::index counts in here
  std::vector<RankedPlace> places;  ///< likewise, one per site
  std::vector<std::string> notes;   ///< beside those of the ranking
};

}  // namespace loosefit

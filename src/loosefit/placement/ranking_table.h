#pragma once
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "loosefit/placement/address.h"
#include "loosefit/placement/rank.h"
#include "loosefit/placement/site_search.h"
#include "loosefit/placement/sites.h"
#include "loosefit/placement/tolerance.h"

namespace loosefit::placement {

/// Where a ranked site lies.
struct RankedPlace {
  std::string region, panel;
  Vec2 at = Vec2::Zero();                   ///< in the pattern [m]
  Vec3 position = Vec3::Zero();             ///< as worn by the first wearer [m]
  double angle = 0;                         ///< of the sensor's axis in the pattern [rad]
  std::optional<BodyAddress> anatomy = {};  ///< on the first wearer
  std::optional<Tolerance> tolerance = {};
  FootprintShape shape = {};
  /// Flat distance from the centre to the nearest seam and hem or opening of the panel [m].
  double to_seam = std::numeric_limits<double>::infinity();
  double to_edge = std::numeric_limits<double>::infinity();
  /// Of a girth: the panels and places that the line goes through.
  std::vector<std::pair<std::string, Vec2>> line = {};
};

/// A ranking with all that its readers want beside it.
struct RankingTable {
  Scorecard scorecard;
  Ranking ranking;
  std::vector<SiteSamples> sites;         ///< what was ranked: RankedSite::index counts in here
  std::vector<RankedPlace> places;        ///< likewise, one per site
  std::vector<std::string> sample_names;  ///< per sample: wearer, and donning if there are several
  SearchConstraints constraints;          ///< as searched, regions filled in
  std::vector<std::string> notes;         ///< beside those of the ranking
  std::vector<UncoveredSite> uncovered;   ///< given places without skin under them; not ranked
};

}  // namespace loosefit::placement

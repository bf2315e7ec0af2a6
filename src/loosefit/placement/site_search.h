#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "loosefit/placement/keep_out.h"
#include "loosefit/placement/pattern_places.h"
#include "loosefit/placement/site_score.h"
#include "loosefit/placement/tolerance.h"

namespace loosefit::placement {

/// What may be asked for, at every door: places to search, and each of the distances below [m].
inline constexpr int kMostPlaces = 1000;
inline constexpr double kLargestClearance = 10;

/// Where a sensor may sit. Distances to borders and zones are those of its outline: the circle
/// about the scorecard's footprint stays clear of them.
struct SearchConstraints {
  double spacing = 0.05;  ///< least straight distance between the centres of two sites, as worn [m]
  double seam_clearance = 0.01, edge_clearance = 0.01;  ///< to seams; to hems and openings [m]
  KeepOut keep_out;
  std::vector<body::Region> regions;  ///< only over these parts of the body; empty: all
};

struct SearchOptions {
  int best = 4;                       ///< sites wanted
  double candidate_spacing = 0.0175;  ///< of the candidates in the flat pattern [m]
  std::uint64_t seed = 1;             ///< of the candidates
  ToleranceOptions tolerance;
};

/// What a search needs to know of the worn garment.
struct SearchField {
  /// Metrics at a place, one map per sample (donning). Called for each candidate, from several
  /// threads at once, and for the shifts of the chosen ones.
  std::function<std::vector<MetricValues>(const PatternPlace&)> metrics;
  /// Direction along the body segment in the pattern; empty: the grain, which runs along the trunk
  /// and along sleeves.
  std::function<Vec2(const PatternPlace&)> along;
  /// Per garment vertex: where it lies as worn in the reference posture [m], for spacing.
  std::vector<Vec3> positions;
  /// Per garment vertex: body region under it; may be empty when no regions are named.
  std::vector<body::Region> regions;
  /// Whether there is skin under a place; empty: everywhere. Other places are no candidates.
  std::function<bool(const PatternPlace&)> covers = {};
  /// Told the share of the candidates that is measured; may throw to stop the search.
  std::function<void(double)> progress = {};
  /// Per sample a number; samples of one number are held out together. Empty: each by itself.
  std::vector<int> held_out_together = {};
};

struct FoundSite {
  PatternPlace place;
  Vec3 position = Vec3::Zero();  ///< as worn [m]
  SiteScore score;
  Tolerance tolerance;
  /// Per sample: its score at the place that a search without this sample puts here (leave one
  /// out). A place is best by chance, too, on the samples that found it. NaN: no such place. Empty:
  /// all samples are held out together.
  std::vector<double> held_out = {};
};

struct SearchResult {
  std::vector<FoundSite> sites;  ///< best first
  /// What became of the candidates; each is counted at the first reason that rules it out.
  int candidates = 0, uncovering = 0, elsewhere = 0, near_seam = 0, near_edge = 0, kept_out = 0,
      not_rated = 0, failing = 0;
  /// Why there are fewer sites than wanted, in words; empty when there are enough.
  std::string shortfall;
};

/// The best places for a modality over the whole garment, chosen greedily by robust score, equal
/// ones by median, then by margin: always the best candidate that keeps `spacing` to those chosen
/// before. Sites that score zero are not chosen. Candidates that the metrics cannot rate are left
/// out and counted.
/// \throws InvalidInput for options out of range, an unknown panel of a zone (with a did-you-mean),
/// or fields that do not fit the garment.
SearchResult search_sites(const garment::Garment& garment, const SearchField& field,
                          const Scorecard& scorecard, const SearchConstraints& constraints,
                          const SearchOptions& options = {});

using PlaceTest = std::function<bool(const PatternPlace&)>;

/// Whether a sensor with an outline of this radius keeps clear of seams, edges, zones and regions
/// as `constraints` ask. Keeps references to garment, field and constraints.
PlaceTest keeps_clear(const garment::Garment& garment, const SearchField& field,
                      const SearchConstraints& constraints, double radius);

/// Tolerance of a place by the robust score of the field; a shift ends where it cannot be rated,
/// and, as at the outline of the panel, where `allowed` says no.
Tolerance site_tolerance(const PatternLocator& locator, const SearchField& field,
                         const Scorecard& scorecard, const PatternPlace& place,
                         const ToleranceOptions& options = {}, const PlaceTest& allowed = {});

}  // namespace loosefit::placement

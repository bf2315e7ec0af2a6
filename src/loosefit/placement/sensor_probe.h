#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "loosefit/body/posed_body.h"
#include "loosefit/placement/footprint_unfold.h"
#include "loosefit/placement/pattern_places.h"
#include "loosefit/placement/scorecard.h"
#include "loosefit/placement/segment_direction.h"
#include "loosefit/placement/site_metrics.h"
#include "loosefit/placement/sites.h"

namespace loosefit::placement {

/// A garment in its reference posture, and the meter that knows all postures and donnings. Only
/// referred to.
struct RankingGround {
  const garment::Garment& garment;
  const std::vector<Vec3>& positions;
  body::PosedBody body;
  const maps::WornGarment& worn;
  const SiteMeter& meter;
};

/// Metrics of one wearer: one map per donning.
using WearerSamples = std::vector<std::map<std::string, double>>;

/// Holds a scorecard's sensor anywhere on one wearer's garment. Keeps references to both arguments
/// and to what the ground refers to. Safe to use from several threads.
class SensorProbe {
 public:
  SensorProbe(const RankingGround& ground, const Scorecard& scorecard);

  /// Of the sensor's axis, along or around the segment as the scorecard asks [rad].
  double angle(int triangle) const;
  /// Direction along the segment in the pattern, unit.
  Vec2 along(const PatternPlace& place) const;
  /// A place by panel and coordinates; nothing where this garment has no cloth.
  std::optional<PatternPlace> find(const std::string& panel, const Vec2& at) const;

  /// Whether there is skin under a place.
  bool covers(const PatternPlace& place) const;

  /// The sensor of a site where the site is; derived metrics are those of its footprint.
  WearerSamples at(const Site& site) const;
  /// The same in every state that counts, one by one.
  std::vector<MetricValues> in_states(const Site& site) const;
  /// A disc, rectangle or line at a place; `turn` is the angle of its axis.
  WearerSamples at(const PatternPlace& place, const FootprintShape& shape, double turn) const;

  const RankingGround& ground() const { return ground_; }
  const PatternLocator& locator() const { return locator_; }

 private:
  SensorPatch patch_of(const Site& site) const;
  WearerSamples measured(const SensorPatch& patch, const FootprintShape& shape) const;

  const RankingGround ground_;
  const Scorecard& scorecard_;
  SegmentDirection directions_;
  TriangleNeighbours neighbours_;
  PatternLocator locator_;
};

}  // namespace loosefit::placement

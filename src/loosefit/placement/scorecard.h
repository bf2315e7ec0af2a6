#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "loosefit/body/regions.h"
#include "loosefit/placement/footprint.h"
#include "loosefit/placement/metric_names.h"

namespace loosefit::placement {

/// Linear ramp of one limit: 1 at `good`, 0 at `fail`. Their order tells the direction: more is
/// better when good > fail, less is better when good < fail; never equal.
struct Ramp {
  double good = 1, fail = 0;
  /// Not clamped: above 1 beyond good, below 0 beyond fail.
  double at(double value) const { return (value - fail) / (good - fail); }
};

/// One need of a sensor: a metric and how good its values are. A range that is good between two
/// values has two ramps, `limit` below and `upper` above it.
struct Criterion {
  std::string metric;  ///< of metric_vocabulary()
  Ramp limit;
  std::optional<Ramp> upper;
  std::string reason;        ///< what is wrong when it limits: "the sensor turns on the body"
  std::string reason_above;  ///< the same when `upper` limits
  std::string source;        ///< where the numbers come from

  /// min over its ramps, not clamped; `above` tells that `upper` is the lower one.
  double ramp(double value, bool* above = nullptr) const;
};

/// What an interval of a metric says of a criterion.
enum class Outlook { passes, fails, open };

/// Of the values from `low` to `high` against the value that scores `pass`, on the line between
/// fail and good of either ramp: open where the interval holds it.
Outlook outlook(const Criterion& criterion, double pass, double low, double high);

/// What one modality needs of its place (docs/theory/sensor_metrics.md 8), read by
/// io/scorecard_file.h.
struct Scorecard {
  std::string name;       ///< "ecg"
  std::string title;      ///< "ECG with dry textile electrodes"
  std::string about;      ///< what is judged, and what is not
  double pass = 0.5;      ///< score from which a site passes
  bool of_lines = false;  ///< judges lines (LineSpec): no footprint, metrics of line_vocabulary()
  FootprintShape footprint;
  bool around = false;  ///< its axis runs around the body segment, otherwise along it
  std::map<std::string, double> parameters;  ///< of derived_metrics.h, SI
  std::vector<Criterion> criteria;
  std::vector<body::Region> regions;  ///< where a search looks by default; empty: everywhere
  std::vector<std::string> left_out;  ///< metrics of criteria dropped by known_part()
};

/// How well a site serves a modality: q = min over criteria of the clamped ramps, never a mean,
/// since one failed need fails the sensor.
struct Score {
  std::optional<double> q;  ///< in [0, 1]; empty: not rated, a metric is missing
  double bound = 1;         ///< q is at most this: minimum over the known criteria
  double margin = 0;        ///< the same without clamping; tells equal scores apart
  int limiting = -1;        ///< index of the criterion with the least margin; -1: none known
  std::vector<std::string> missing;  ///< metrics without which there is no score
  /// The limiting criterion with figure and unit: "the electrode is pressed too lightly: 0.45 kPa,
  /// good from 1, fails at 0.3"; with a full score what comes nearest to limiting: "all needs met;
  /// nearest: contact pressure 1.2 kPa, good from 1"; or "not rated: needs slip_mm (several
  /// postures)".
  std::string reason;
};

/// Judges metrics, derived ones included as far as the scorecard's parameters allow.
/// A metric that is absent or not finite is missing.
Score score(const MetricValues& metrics, const Scorecard& scorecard);

/// The scorecard without the criteria whose metric `metrics` lacks; they are named in left_out.
/// Scores by it are upper bounds of the full ones.
Scorecard known_part(const Scorecard& scorecard, const MetricValues& metrics);

}  // namespace loosefit::placement

#pragma once
#include <map>
#include <string>
#include <vector>

namespace loosefit::placement {

/// Numbers by which a site is judged, by metric name; the unit is part of the name. A metric that
/// is not known is left out (or NaN), never zero.
using MetricValues = std::map<std::string, double>;

/// One word of the vocabulary that scorecards and site metrics share (docs/theory/sensor_metrics.md
/// 2 to 8).
struct MetricName {
  std::string name;   ///< "coe_rms_deg"
  std::string unit;   ///< as a scorecard must state it: "deg", "mm", "kPa", "pF", "K", "-"
  std::string words;  ///< "calibrated orientation error, RMS over postures"
  std::string needs;  ///< what must have been simulated: "several postures"; empty: any drape
};

/// The whole vocabulary, derived metrics (derived_metrics.h) last.
const std::vector<MetricName>& metric_vocabulary();

/// The words of sensors that are lines (lines/line_metrics.h); scorecards of lines use no others.
const std::vector<MetricName>& line_vocabulary();

/// In both; nullptr for an unknown name.
const MetricName* find_metric(const std::string& name);

/// "coe_rms_deg (several postures)", or the bare name when any drape has it.
std::string metric_with_need(const std::string& name);

}  // namespace loosefit::placement

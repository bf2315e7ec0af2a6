#include "loosefit/placement/metric_names.h"

#include <algorithm>
#include <utility>

#include "loosefit/placement/catalogue_metrics.h"

namespace loosefit::placement {
namespace {
/// Of derived_metrics.h.
std::vector<MetricName> derived_names() {
  const char* postures = needs(maps::OverStates::swing);
  return {
      {"usable_signal_ratio", "-", "strain swing over the sensor's error", postures},
      {"pre_strain_margin", "-", "strain less its range over postures", postures},
      {"strain_peak", "-", "strain plus its range over postures", postures},
      {"capacitance_pF", "pF", "capacitance to the skin", ""},
      {"capacitance_swing", "-", "relative change of capacitance over postures", postures},
      {"temperature_error_K", "K", "error of the skin temperature by the gap", ""},
      {"sensor_diameter_mm", "mm", "diameter of the sensor", ""},
  };
}

}  // namespace

const std::vector<MetricName>& metric_vocabulary() {
  static const std::vector<MetricName> kWords = [] {
    std::vector<MetricName> words;
    for (const CatalogueMetric& source : catalogue_metrics()) {
      const std::string& unit = source.array->style.unit;
      words.push_back({source.metric->name, unit == "–" ? "-" : unit, source.metric->words,
                       needs(source.metric->states)});
    }
    for (MetricName& derived : derived_names()) words.push_back(std::move(derived));
    return words;
  }();
  return kWords;
}

const std::vector<MetricName>& line_vocabulary() {
  const char* postures = needs(maps::OverStates::swing);
  const char* donnings = "several donnings";
  const char* sweep = "a sweep of one joint";
  static const std::vector<MetricName> kWords = {
      {"line_elongation", "-", "elongation of the line in the reference posture", ""},
      {"line_elongation_most", "-", "greatest elongation of the line", ""},
      {"line_elongation_least", "-", "least elongation of the line", ""},
      {"line_part_elongation", "-", "greatest elongation of any part of the line", ""},
      {"line_part_strain", "-", "greatest strain of any part of the line, either way", ""},
      {"line_swing", "-", "swing of the line's signal over postures", postures},
      {"line_swing_mm", "mm", "swing of the line's length over postures", postures},
      {"line_force_N", "N", "greatest tension of the line", ""},
      {"line_slack", "-", "share of the line that is slack", ""},
      {"line_contact", "-", "share of the line that touches the skin", ""},
      {"line_bend_radius_mm", "mm", "least radius to which the line is bent", ""},
      {"line_donning_shift", "-", "change of the line's length from one donning to the next",
       donnings},
      {"line_gain_percent_per_deg", "-", "change of the signal in percent per degree", sweep},
      {"line_monotone_share", "-", "share of the sweep in which the signal is unambiguous", sweep},
      {"line_angle_error_deg", "deg", "error of the joint's angle from one donning to the next",
       "a sweep of one joint in several donnings"},
  };
  return kWords;
}

const MetricName* find_metric(const std::string& name) {
  for (const std::vector<MetricName>* words : {&metric_vocabulary(), &line_vocabulary()})
    for (const MetricName& word : *words)
      if (word.name == name) return &word;
  return nullptr;
}

std::string metric_with_need(const std::string& name) {
  const MetricName* metric = find_metric(name);
  return metric && !metric->needs.empty() ? name + " (" + metric->needs + ")" : name;
}

}  // namespace loosefit::placement

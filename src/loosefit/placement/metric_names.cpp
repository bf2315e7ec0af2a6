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
const MetricName* find_metric(const std::string& name) {
  const auto& all = metric_vocabulary();
  const auto at =
      std::find_if(all.begin(), all.end(), [&](const MetricName& m) { return m.name == name; });
  return at == all.end() ? nullptr : &*at;
}

std::string metric_with_need(const std::string& name) {
  const MetricName* metric = find_metric(name);
  return metric && !metric->needs.empty() ? name + " (" + metric->needs + ")" : name;
}

}  // namespace loosefit::placement

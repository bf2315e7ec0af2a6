#include "loosefit/pipeline/site_values.h"

#include <nlohmann/json.hpp>

#include "loosefit/maps/mesh_error.h"

namespace loosefit::pipeline {

std::string map_mean_name(const std::string& array) {
  return placement::find_metric(array) ? array + "_map" : array;
}

std::map<std::string, double> site_values(const placement::Site& site) {
  std::map<std::string, double> values = site.metrics();
  for (const auto& [array, value] : site.map_values) {
    values[map_mean_name(array)] = value.mean;
    values[array + "_worst"] = value.worst;
  }
  return values;
}

std::map<std::string, Uncertainty> site_uncertainty(const placement::Site& site,
                                                    double edge_length) {
  std::map<std::string, Uncertainty> known;
  for (const auto& [array, value] : site.map_values)
    if (const auto error = maps::mesh_error(array, value.mean, edge_length))
      known[map_mean_name(array)].mesh = error;
  for (const auto& [metric, value] : site.metrics()) {
    if (const auto error = maps::mesh_error(metric, value, edge_length)) known[metric].mesh = error;
    std::vector<double> samples;
    for (const placement::MetricValues& sample : site.samples)
      if (const auto at = sample.find(metric); at != sample.end() && std::isfinite(at->second))
        samples.push_back(at->second);
    if (samples.size() < 2) continue;
    double mean = 0, squares = 0;
    for (const double x : samples) mean += x / static_cast<double>(samples.size());
    for (const double x : samples) squares += (x - mean) * (x - mean);
    known[metric].donnings = std::sqrt(squares / static_cast<double>(samples.size() - 1));
  }
  return known;
}

std::string footprint_json(const placement::FootprintShape& shape) {
  using Kind = placement::FootprintShape::Kind;
  nlohmann::ordered_json json;
  switch (shape.kind) {
    case Kind::disc:
      json["radius_m"] = shape.radius;
      break;
    case Kind::rectangle:
      json["size_m"] = {shape.size.x(), shape.size.y()};
      break;
    case Kind::line:
      json["length_m"] = shape.length;
      break;
    case Kind::girth:
      json["girth"] = true;
  }
  return json.dump();
}

}  // namespace loosefit::pipeline

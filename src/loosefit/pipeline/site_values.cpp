#include "loosefit/pipeline/site_values.h"

#include <nlohmann/json.hpp>

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

#pragma once
#include <cmath>
#include <map>
#include <optional>
#include <string>

#include "loosefit/placement/sites.h"

namespace loosefit::pipeline {

/// The name under which the mean of a map's points in a footprint is told: the array's own, or
/// `<array>_map` where a metric of the sensor has that name: the sensor's value then has it.
std::string map_mean_name(const std::string& array);

/// All numbers of a site by name, the same in every output (docs/outputs.md): the metrics of its
/// sensor, medians over its samples; of every map the mean of the points in the footprint under
/// map_mean_name() and the value that 95 % of them stay below, `<array>_worst`. NaN where a map is
/// not defined.
std::map<std::string, double> site_values(const placement::Site& site);

/// What a number of a site may be off by, as standard deviations in its unit.
struct Uncertainty {
  std::optional<double> mesh;      ///< maps/mesh_error.h; absent: not known
  std::optional<double> donnings;  ///< over the samples of the sensor; absent: one sample
  double whole() const { return std::hypot(mesh.value_or(0), donnings.value_or(0)); }
};

/// Of those site_values() of which something is known. edge_length: of the mesh [m].
std::map<std::string, Uncertainty> site_uncertainty(const placement::Site& site,
                                                    double edge_length);

/// A footprint as JSON: { "radius_m" }, { "size_m": [across, along] }, { "length_m" } or
/// { "girth": true }.
std::string footprint_json(const placement::FootprintShape& shape);

}  // namespace loosefit::pipeline

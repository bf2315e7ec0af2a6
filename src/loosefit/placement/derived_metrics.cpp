#include "loosefit/placement/derived_metrics.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace loosefit::placement {
namespace {

constexpr double kVacuumPermittivity = 8.8541878128e-12;  // F/m, CODATA 2018
constexpr double kAirConductivity = 0.026;                // W/(m K), still air at skin temperature

/// Inputs in the order in which they are named below.
using Inputs = std::vector<double>;

struct Derived {
  std::string name;
  std::vector<std::string> metrics, parameters;
  std::function<double(const Inputs& metric, const Inputs& parameter, const FootprintShape&)> value;
};

/// Half of the longest side or of the diameter [m]; NaN for a girth, which has no end.
double outer_extent(const FootprintShape& shape) {
  switch (shape.kind) {
    case FootprintShape::Kind::disc:
      return shape.radius;
    case FootprintShape::Kind::rectangle:
      return 0.5 * shape.size.maxCoeff();
    case FootprintShape::Kind::line:
      return 0.5 * shape.length;
    case FootprintShape::Kind::girth:
      break;
  }
  return std::nan("");
}

const std::vector<Derived>& derived() {
  static const std::vector<Derived> kAll = {
      {"usable_signal_ratio",
       {"strain_swing"},
       {"strain_error"},
       [](const Inputs& m, const Inputs& p, const FootprintShape&) { return m[0] / p[0]; }},
      {"pre_strain_margin",
       {"strain", "strain_swing"},
       {},
       [](const Inputs& m, const Inputs&, const FootprintShape&) { return m[0] - m[1]; }},
      {"strain_peak",
       {"strain", "strain_swing"},
       {},
       [](const Inputs& m, const Inputs&, const FootprintShape&) { return m[0] + m[1]; }},
      {"capacitance_pF",
       {"gap_mm"},
       {"dielectric_thickness", "dielectric_constant"},
       [](const Inputs& m, const Inputs& p, const FootprintShape& footprint) {
         const double gap = std::max(0.0, 1e-3 * m[0]);
         return 1e12 * kVacuumPermittivity * area(footprint) / (p[0] / p[1] + gap);
       }},
      {"capacitance_swing",
       {"gap_mm", "gap_swing_mm"},
       {"dielectric_thickness", "dielectric_constant"},
       [](const Inputs& m, const Inputs& p, const FootprintShape&) {
         return 1e-3 * m[1] / (std::max(0.0, 1e-3 * m[0]) + p[0] / p[1]);
       }},
      {"temperature_error_K",
       {"gap_mm"},
       {"skin_temperature", "air_temperature", "outer_resistance"},
       [](const Inputs& m, const Inputs& p, const FootprintShape&) {
         const double gap = std::max(0.0, 1e-3 * m[0]) / kAirConductivity;
         return (p[0] - p[1]) * gap / (gap + p[2]);
       }},
      {"sensor_diameter_mm",
       {},
       {},
       [](const Inputs&, const Inputs&, const FootprintShape& footprint) {
         return 2e3 * outer_extent(footprint);
       }},
  };
  return kAll;
}

/// Values of `names` in order; empty when one is missing or not finite.
Inputs look_up(const std::vector<std::string>& names, const std::map<std::string, double>& values) {
  Inputs found;
  for (const std::string& name : names) {
    const auto at = values.find(name);
    if (at == values.end() || !std::isfinite(at->second)) return {};
    found.push_back(at->second);
  }
  return found;
}

}  // namespace

const std::vector<SensorParameter>& sensor_parameters() {
  static const std::vector<SensorParameter> kAll = {
      {"strain_error", 1e-5, 1, "a strain", "error of the sensor's reading"},
      {"dielectric_thickness", 1e-6, 0.02, "metres", "insulation between electrode and skin"},
      {"dielectric_constant", 1, 100, "a relative permittivity", "of that insulation"},
      {"skin_temperature", 20, 45, "degrees Celsius", "under the sensor"},
      {"air_temperature", -40, 60, "degrees Celsius", "around the wearer"},
      {"outer_resistance", 1e-3, 10, "m²K/W", "from the sensor to the air"},
  };
  return kAll;
}

std::vector<std::string> parameters_of(const std::string& metric) {
  for (const Derived& d : derived())
    if (d.name == metric) return d.parameters;
  return {};
}

MetricValues with_derived(const MetricValues& metrics,
                          const std::map<std::string, double>& parameters,
                          const FootprintShape& footprint) {
  MetricValues all = metrics;
  for (const Derived& d : derived()) {
    if (all.count(d.name)) continue;
    const Inputs metric = look_up(d.metrics, metrics);
    const Inputs parameter = look_up(d.parameters, parameters);
    if (metric.size() != d.metrics.size() || parameter.size() != d.parameters.size()) continue;
    const double value = d.value(metric, parameter, footprint);
    if (std::isfinite(value)) all[d.name] = value;
  }
  return all;
}

}  // namespace loosefit::placement

#pragma once
#include <map>
#include <string>
#include <vector>

#include "loosefit/placement/footprint.h"
#include "loosefit/placement/metric_names.h"

namespace loosefit::placement {

/// A number about the sensor that derived metrics need, as a scorecard states it in [sensor].
struct SensorParameter {
  std::string name;
  double low = 0, high = 0;  ///< allowed values
  std::string unit;          ///< SI
  std::string words;
};

/// strain_error, dielectric_thickness, dielectric_constant, skin_temperature, air_temperature,
/// outer_resistance.
const std::vector<SensorParameter>& sensor_parameters();

/// Parameters without which `metric` cannot be derived; empty for a metric that is not derived or
/// needs none.
std::vector<std::string> parameters_of(const std::string& metric);

/// The metrics with all that follow from them, from a scorecard's parameters (SI) and from its
/// footprint (docs/theory/sensor_metrics.md 6 and 8):
///
///   usable_signal_ratio = strain_swing / ε_err
///   pre_strain_margin   = strain − strain_swing   (≥ 0: no posture makes the sensor slack, since
///                                                  no shortening can exceed the whole swing)
///   strain_peak         = strain + strain_swing
///   capacitance_pF      = ε₀ A / (t/ε_r + g)
///   capacitance_swing   = Δg / (g + t/ε_r)
///   temperature_error_K = (T_skin − T_air) R_gap / (R_gap + R_out),  R_gap = g / (0.026 W/(m K))
///   sensor_diameter_mm  = 2 r of a disc, the longer side of a rectangle, the length of a line
///
/// with g the footprint's mean gap, Δg its range over postures, A and r of the footprint, ε_err
/// strain_error, t dielectric_thickness, ε_r dielectric_constant, R_out outer_resistance. The mean
/// gap makes capacitance_pF a lower bound: C is convex in g. A derived metric that is already among
/// `metrics` is kept; one that lacks an input is left out.
MetricValues with_derived(const MetricValues& metrics,
                          const std::map<std::string, double>& parameters,
                          const FootprintShape& footprint);

}  // namespace loosefit::placement

#include "loosefit/placement/metric_names.h"

#include <algorithm>

namespace loosefit {
namespace {
constexpr const char* kPostures = "several postures";
constexpr const char* kDonnings = "several donnings";
}  // namespace

const std::vector<MetricName>& metric_vocabulary() {
  static const std::vector<MetricName> kWords = {
      {"angular_deviation_deg", "deg", "angle between garment and body normal", ""},
      {"tilt_sagittal_deg", "deg", "tilt about the axis across the segment", ""},
      {"tilt_lateral_deg", "deg", "tilt about the segment's long axis", ""},
      {"twist_deg", "deg", "rotation about the normal", ""},
      {"rotation_deg", "deg", "total rotation of the sensor against the body", ""},
      {"coe_rms_deg", "deg", "calibrated orientation error, RMS over postures", kPostures},
      {"coe_p95_deg", "deg", "calibrated orientation error, 95 % of postures", kPostures},
      {"donning_coe_deg", "deg", "orientation error from one donning to the next", kDonnings},
      {"gap_mm", "mm", "gap to the skin, mean of the footprint", ""},
      {"gap_worst_mm", "mm", "gap to the skin, worst 5 % of the footprint", ""},
      {"gap_swing_mm", "mm", "range of the gap over postures", kPostures},
      {"contact_ratio", "-", "share of the footprint that touches the skin", ""},
      {"contact_duty", "-", "share of postures with at least 0.9 in contact", kPostures},
      {"pressure_kPa", "kPa", "contact pressure", ""},
      {"pressure_min_kPa", "kPa", "lowest contact pressure over postures", kPostures},
      {"pressure_swing_kPa", "kPa", "range of the contact pressure over postures", kPostures},
      {"strain", "-", "strain along the sensor", ""},
      {"strain_swing", "-", "range of the strain over postures", kPostures},
      {"slack", "-", "share of the footprint that is buckled", ""},
      {"slip_mm", "mm", "travel along the skin over postures", kPostures},
      {"usable_signal_ratio", "-", "strain swing over the sensor's error", kPostures},
      {"pre_strain_margin", "-", "strain less its range over postures", kPostures},
      {"strain_peak", "-", "strain plus its range over postures", kPostures},
      {"capacitance_pF", "pF", "capacitance to the skin", ""},
      {"capacitance_swing", "-", "relative change of capacitance over postures", kPostures},
      {"temperature_error_K", "K", "error of the skin temperature by the gap", ""},
      {"sensor_diameter_mm", "mm", "diameter of the sensor", ""},
  };
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

}  // namespace loosefit

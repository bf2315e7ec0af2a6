#include "loosefit/body/plausible_measures.h"

#include <algorithm>

#include "loosefit/base/error.h"
#include "loosefit/base/text.h"
#include "loosefit/body/body_tape.h"

namespace loosefit::body {

const std::vector<PlausibleMeasure>& plausible_measures() {
  static const std::vector<PlausibleMeasure> kMeasures = {
      {"height", 0.70, 2.30},     {"chest", 0.35, 1.80},       {"underbust", 0.33, 1.70},
      {"waist", 0.30, 1.90},      {"hip", 0.33, 1.90},         {"neck", 0.18, 0.65},
      {"mid_neck", 0.16, 0.62},   {"upper_arm", 0.10, 0.62},   {"forearm", 0.09, 0.48},
      {"wrist", 0.07, 0.28},      {"thigh", 0.18, 1.00},       {"knee", 0.14, 0.70},
      {"calf", 0.12, 0.65},       {"ankle", 0.09, 0.42},       {"shoulder_breadth", 0.15, 0.62},
      {"arm_length", 0.18, 0.85}, {"back_length", 0.15, 0.62}, {"crotch_height", 0.18, 1.20}};
  return kMeasures;
}

const PlausibleMeasure& plausible_measure(const std::string& name) {
  const auto found = std::ranges::find(plausible_measures(), name, &PlausibleMeasure::name);
  if (found == plausible_measures().end())
    throw InvalidInput({"", 0, "measurements"}, "\"" + printable(name) + "\"", "a known measure",
                       did_you_mean(name, measure_names()));
  return *found;
}

}  // namespace loosefit::body

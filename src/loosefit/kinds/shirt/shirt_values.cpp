#include "loosefit/kinds/shirt/shirt_values.h"

#include <algorithm>

#include "loosefit/base/types.h"

namespace loosefit::kinds {

ShirtFit usual_shirt_fit() {
  return {.chest = 0.10, .waist = {}, .hip = 0.08, .sleeve = 0.15, .wrist = 0.20};
}

double arm_girth_at(const ShirtMeasures& m, double share) {
  constexpr double kAboveElbow = 0.5;
  const double down = std::clamp((share - kAboveElbow) / (1 - kAboveElbow), 0.0, 1.0);
  return (1 - down) * m.upper_arm + down * m.wrist;
}

const std::vector<ShirtMeasure>& shirt_measure_list() {
  using M = ShirtMeasures;
  static const std::vector<ShirtMeasure> kList = {
      {"chest", &M::chest, 0.35, 2.2, " m"},
      {"waist", &M::waist, 0.30, 2.2, " m"},
      {"hip", &M::hip, 0.35, 2.2, " m"},
      {"neck", &M::neck, 0.15, 0.80, " m"},
      {"upper_arm", &M::upper_arm, 0.08, 0.90, " m"},
      {"wrist", &M::wrist, 0.06, 0.40, " m"},
      {"shoulder_breadth", &M::shoulder_breadth, 0.15, 0.80, " m"},
      {"shoulder_slope", &M::shoulder_slope, 0.0, radians(45), " rad"},
      {"scye_depth", &M::scye_depth, 0.05, 0.35, " m"},
      {"hps_to_waist", &M::hps_to_waist, 0.15, 0.80, " m"},
      {"hps_to_hem", &M::hps_to_hem, 0.20, 1.60, " m"},
      {"arm_length", &M::arm_length, 0.15, 1.0, " m"},
  };
  return kList;
}

const std::vector<ShirtFitValue>& shirt_fit_list() {
  using F = ShirtFit;
  static const std::vector<ShirtFitValue> kList = {{"chest", &F::chest},
                                                   {"hip", &F::hip},
                                                   {"sleeve", &F::sleeve},
                                                   {"wrist", &F::wrist},
                                                   {"neck_ease", &F::neck_ease},
                                                   {"scye_ease", &F::scye_ease},
                                                   {"shoulder_follow", &F::shoulder_follow},
                                                   {"cap_ease", &F::cap_ease},
                                                   {"sleeve_length", &F::sleeve_length}};
  return kList;
}

ShirtMeasures shirt_measures_of(const NamedValues& values, const ShirtMeasures& otherwise) {
  ShirtMeasures measures = otherwise;
  for (const ShirtMeasure& m : shirt_measure_list())
    if (const auto found = values.find(m.name); found != values.end())
      measures.*m.field = found->second;
  return measures;
}

ShirtFit shirt_fit_of(const NamedValues& values, const ShirtFit& otherwise) {
  ShirtFit fit = otherwise;
  for (const ShirtFitValue& f : shirt_fit_list())
    if (const auto found = values.find(f.name); found != values.end()) fit.*f.field = found->second;
  if (const auto waist = values.find("waist"); waist != values.end()) fit.waist = waist->second;
  return fit;
}

NamedValues named(const ShirtMeasures& measures) {
  NamedValues values;
  for (const ShirtMeasure& m : shirt_measure_list()) values[m.name] = measures.*m.field;
  return values;
}

NamedValues named(const ShirtFit& fit) {
  NamedValues values;
  for (const ShirtFitValue& f : shirt_fit_list()) values[f.name] = fit.*f.field;
  if (fit.waist) values["waist"] = *fit.waist;
  return values;
}

const std::vector<ShirtPart>& shirt_parts() {
  static const std::vector<ShirtPart> kParts = {
      {"front", false, false, 0},          {"back", false, true, 0},
      {"sleeve_L_front", true, false, 1},  {"sleeve_L_back", true, true, 1},
      {"sleeve_R_front", true, false, -1}, {"sleeve_R_back", true, true, -1}};
  return kParts;
}

const ShirtPart* find_shirt_part(const std::string& name) {
  const auto found = std::find_if(shirt_parts().begin(), shirt_parts().end(),
                                  [&](const ShirtPart& part) { return name == part.name; });
  return found == shirt_parts().end() ? nullptr : &*found;
}

}  // namespace loosefit::kinds

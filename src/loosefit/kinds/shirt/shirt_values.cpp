#include "loosefit/kinds/shirt/shirt_values.h"

#include <algorithm>
#include <cmath>

#include "loosefit/base/types.h"

namespace loosefit::kinds {

ShirtFit usual_shirt_fit() {
  return {.chest = 0.10,
          .hip = 0.08,
          .sleeve = 0.25,
          .wrist = 0.25,
          .cap_ease = 0.02,
          .sleeve_follow = 1,
          .cuff_stretch = 0.10};
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
      // Shares of upper arm and wrist: judgement. Elbow at 0.56 of the arm: acromion to radiale and
      // to wrist in ANSUR II (Gordon et al. 2014), women and men. Neck: as on the parametric body.
      {"elbow", &M::elbow, 0.06, 0.90, " m",
       [](const M& m) { return m.wrist + 0.82 * (m.upper_arm - m.wrist); }},
      {"forearm", &M::forearm, 0.06, 0.80, " m",
       [](const M& m) { return m.wrist + 0.72 * (m.upper_arm - m.wrist); }},
      {"elbow_length", &M::elbow_length, 0.08, 0.70, " m",
       [](const M& m) { return 0.56 * m.arm_length; }},
      {"neck_width", &M::neck_width, 0.04, 0.35, " m", [](const M& m) { return 0.31 * m.neck; }},
      {"neck_depth_back", &M::neck_depth_back, 0, 0.12, " m",
       [](const M& m) { return 0.13 * m.neck; }},
      {"shoulder_length", &M::shoulder_length, 0.03, 0.35, " m",
       [](const M& m) {
         return (0.46 * m.shoulder_breadth - 0.5 * m.neck_width) / std::cos(m.shoulder_slope);
       }},
      {"front_fullness", &M::front_fullness, -0.10, 0.15, " m", [](const M&) { return 0.0; }},
      {"front_balance", &M::front_balance, -0.10, 0.25, " m", [](const M&) { return 0.0; }},
      // Bust points 19.4 cm apart and 27.2 cm down at EU 38: judgement.
      {"bust_balance", &M::bust_balance, -0.15, 0.20, " m", [](const M&) { return 0.0; }},
      {"bust_span", &M::bust_span, 0.04, 0.60, " m", [](const M& m) { return 0.22 * m.chest; }},
      {"hps_to_bust", &M::hps_to_bust, 0.05, 0.80, " m",
       [](const M& m) { return 0.64 * m.hps_to_waist; }},
  };
  return kList;
}

ShirtMeasures with_usual_measures(ShirtMeasures measures) {
  for (const ShirtMeasure& m : shirt_measure_list())
    if (m.usual) measures.*m.field = m.usual(measures);
  return measures;
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
                                                   {"cap_ratio", &F::cap_ratio},
                                                   {"sleeve_length", &F::sleeve_length},
                                                   {"bust_dart", &F::bust_dart},
                                                   {"back_waist", &F::back_waist},
                                                   {"sleeve_follow", &F::sleeve_follow},
                                                   {"elbow_bend", &F::elbow_bend},
                                                   {"neckband_width", &F::neckband},
                                                   {"neckband_stretch", &F::neckband_stretch},
                                                   {"cuff_width", &F::cuff},
                                                   {"cuff_stretch", &F::cuff_stretch},
                                                   {"band_stiffness", &F::band_stiffness},
                                                   {"edge_finish", &F::edge_finish}};
  return kList;
}

const std::vector<ShirtFitOption>& shirt_fit_options() {
  using F = ShirtFit;
  static const std::vector<ShirtFitOption> kList = {
      {"waist", &F::waist}, {"elbow", &F::elbow}, {"forearm", &F::forearm}};
  return kList;
}

ShirtMeasures shirt_measures_of(const BodyMeasures& values, const ShirtMeasures& otherwise) {
  ShirtMeasures measures = otherwise;
  measures.along = values.along;
  for (const ShirtMeasure& m : shirt_measure_list())
    if (const auto found = values.find(m.name); found != values.end())
      measures.*m.field = found->second;
    else if (m.usual)
      measures.*m.field = m.usual(measures);
  return measures;
}

ShirtFit shirt_fit_of(const NamedValues& values, const ShirtFit& otherwise) {
  ShirtFit fit = otherwise;
  for (const ShirtFitValue& f : shirt_fit_list())
    if (const auto found = values.find(f.name); found != values.end()) fit.*f.field = found->second;
  for (const ShirtFitOption& f : shirt_fit_options())
    if (const auto found = values.find(f.name); found != values.end()) fit.*f.field = found->second;
  return fit;
}

BodyMeasures named(const ShirtMeasures& measures) {
  BodyMeasures values;
  values.along = measures.along;
  for (const ShirtMeasure& m : shirt_measure_list()) values[m.name] = measures.*m.field;
  return values;
}

NamedValues named(const ShirtFit& fit) {
  NamedValues values;
  for (const ShirtFitValue& f : shirt_fit_list()) values[f.name] = fit.*f.field;
  for (const ShirtFitOption& f : shirt_fit_options())
    if (fit.*f.field) values[f.name] = *(fit.*f.field);
  return values;
}

const std::vector<ShirtPart>& shirt_parts() {
  static const std::vector<ShirtPart> kParts = {{"front", false, false, 0},
                                                {"back", false, true, 0},
                                                {"sleeve_L_front", true, false, 1},
                                                {"sleeve_L_back", true, true, 1},
                                                {"sleeve_R_front", true, false, -1},
                                                {"sleeve_R_back", true, true, -1},
                                                {"neckband_front", false, false, 0, true},
                                                {"neckband_back", false, true, 0, true},
                                                {"cuff_L_front", true, false, 1, true},
                                                {"cuff_L_back", true, true, 1, true},
                                                {"cuff_R_front", true, false, -1, true},
                                                {"cuff_R_back", true, true, -1, true}};
  return kParts;
}

const ShirtPart* find_shirt_part(const std::string& name) {
  const auto found = std::find_if(shirt_parts().begin(), shirt_parts().end(),
                                  [&](const ShirtPart& part) { return name == part.name; });
  return found == shirt_parts().end() ? nullptr : &*found;
}

}  // namespace loosefit::kinds

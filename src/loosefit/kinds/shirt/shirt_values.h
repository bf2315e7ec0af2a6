#pragma once
#include <optional>
#include <string>
#include <vector>

#include "loosefit/kinds/named_values.h"

namespace loosefit::kinds {

/// Body sizes the shirt is drafted from [m, rad]. Girths are tape girths (convex hull of the
/// section). The preset is a standard adult woman, size M (EU 38).
struct ShirtMeasures {
  double chest = 0.880;             ///< C, under the arms
  double waist = 0.720;             ///< W
  double hip = 0.960;               ///< H, at hem level
  double neck = 0.360;              ///< N, neck base
  double upper_arm = 0.284;         ///< B
  double wrist = 0.160;             ///< R
  double shoulder_breadth = 0.385;  ///< S, shoulder point to shoulder point over the back
  double shoulder_slope = 0.3490658503988659;  ///< alpha [rad]; 20°
  double scye_depth = 0.145;                   ///< D0, shoulder point to armpit, vertical
  double hps_to_waist = 0.425;                 ///< l_w, high point shoulder to waist
  double hps_to_hem = 0.630;                   ///< l_h, high point shoulder to hem
  double arm_length = 0.585;                   ///< l_a, shoulder point to wrist
};

/// Body-garment mobility of each level, garment girth / body girth − 1 (Harms et al. 2012), and
/// ease.
struct ShirtFit {
  double chest = 0.05;
  std::optional<double> waist;  ///< absent: side seams run straight from underarm to hem
  double hip = 0.05;
  double sleeve = 0.10;  ///< at the upper arm
  double wrist = 0.15;
  double neck_ease = 0.10;       ///< share added to the neck width
  double scye_ease = 0.025;      ///< underarm below the armpit [m]
  double shoulder_follow = 0.5;  ///< share of a positive chest fit that widens the shoulders
  double cap_ease = 0.0;         ///< sleeve cap longer than the armhole by this share
  /// Sleeve, from the shoulder point to its hem, as a share of the arm; below 1 `wrist` counts
  /// against arm_girth_at there.
  double sleeve_length = 1.0;
};

/// The fit of a shirt where nothing else is asked for: the only place of these defaults.
ShirtFit usual_shirt_fit();

/// Girth of the arm at a share of the way from the shoulder point to the wrist [m]: that of the
/// upper arm to half way, above the elbow, then even down to the wrist (forearms are nearly cones).
double arm_girth_at(const ShirtMeasures& measures, double share);

/// A measure with its name and the range of people [m, rad].
struct ShirtMeasure {
  const char* name;
  double ShirtMeasures::*field;
  double low, high;
  const char* unit;  ///< for messages: " m", " rad"
};
const std::vector<ShirtMeasure>& shirt_measure_list();

/// A number of ShirtFit with its name; fit.waist, which may be absent, is not among them.
struct ShirtFitValue {
  const char* name;
  double ShirtFit::*field;
};
const std::vector<ShirtFitValue>& shirt_fit_list();

/// The same as named values and back; of a missing one the value of `otherwise` stays.
ShirtMeasures shirt_measures_of(const NamedValues& values, const ShirtMeasures& otherwise = {});
ShirtFit shirt_fit_of(const NamedValues& values, const ShirtFit& otherwise = {});
NamedValues named(const ShirtMeasures& measures);
NamedValues named(const ShirtFit& fit);

/// A piece of the draft.
struct ShirtPart {
  const char* name;
  bool sleeve, back;
  int side;  ///< of a sleeve: +1 left, −1 right
};
/// In the order of the draft.
const std::vector<ShirtPart>& shirt_parts();
/// By Panel::part; nullptr for what is no piece of a shirt.
const ShirtPart* find_shirt_part(const std::string& name);

}  // namespace loosefit::kinds

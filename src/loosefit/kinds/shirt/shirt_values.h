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
  double arm_length = 0.585;                   ///< l_a, shoulder point to wrist, elbow bent
  // What a size table or a scan may not know; then it follows from the others.
  double elbow = 0.26168;            ///< round the bent elbow
  double forearm = 0.24928;          ///< where it is fullest
  double elbow_length = 0.3276;      ///< shoulder point to elbow
  double neck_width = 0.1116;        ///< between the high point shoulders
  double neck_depth_back = 0.0468;   ///< high point shoulder to C7, in the plane of symmetry
  double shoulder_length = 0.12908;  ///< high point shoulder to shoulder point
  double front_fullness = 0;         ///< the chest in front of the sides, beyond half of it
  double front_balance = 0;          ///< high point shoulder to hem level, front longer than back
  double bust_balance = 0;           ///< shoulder seam to bust level, front longer than back
  double bust_span = 0.1936;         ///< between the bust points
  double hps_to_bust = 0.272;        ///< high point shoulder to bust level, down the front
  GirthsAlong along = {};            ///< along the limbs; empty for a table of sizes
};

/// Body-garment mobility of each level, garment girth / body girth − 1 (Harms et al. 2012), and
/// ease.
struct ShirtFit {
  double chest = 0.05;
  /// Absent: side seams run straight from underarm to hem, and outwards where a belly needs room.
  std::optional<double> waist = {};
  double hip = 0.05;
  double sleeve = 0.10;  ///< at the upper arm
  /// At the bent elbow and round the forearm; absent: even between sleeve and wrist.
  std::optional<double> elbow = {}, forearm = {};
  double wrist = 0.15;
  double neck_ease = 0.06;       ///< share added to the neck base, in length and in width
  double scye_ease = 0.025;      ///< underarm below the armpit [m]
  double shoulder_follow = 0.5;  ///< share of a positive chest fit that widens the shoulders
  double cap_ease = 0.0;         ///< sleeve cap longer than the armhole by this share
  /// Cap height / armhole depth that the draft seeks: high for arms that hang, low for arms that
  /// are raised.
  double cap_ratio = 0.75;
  /// Sleeve, from the shoulder point to its hem, as a share of the arm; below 1 `wrist` counts
  /// against arm_girth_at there.
  double sleeve_length = 1.0;
  double bust_dart = 0;   ///< share of the bust balance that darts at the sides take up
  double back_waist = 0;  ///< taken in at the waist by darts of the back [m]
  /// 1: every place of the sleeve has the ease asked for there; 0: it tapers evenly from the upper
  /// arm where that leaves more room (sleeve_ease.h).
  double sleeve_follow = 0;
  /// Bend at the elbow for which the sleeve is cut [degrees]; its length is taken up in a dart.
  double elbow_bend = 0;
  double neckband = 0;  ///< width of the strip round the neck [m]; 0: none
  /// A straight strip, shorter than the neckline by this share; 0: cut curved, as the neckline is.
  double neckband_stretch = 0;
  /// Width of the strip at the end of the sleeve [m]; 0: none. `wrist` counts against the arm at
  /// its seam then.
  double cuff = 0;
  double cuff_stretch = 0;    ///< strip shorter than the sleeve's end by this share
  double band_stiffness = 2;  ///< of the strips in the plane, times that of the fabric
  double edge_finish = 0;     ///< width of the hems along free edges [m]; 0: none
};

/// The fit of a shirt where nothing else is asked for: the only place of these defaults.
ShirtFit usual_shirt_fit();

/// A measure with its name and the range of people [m, rad].
struct ShirtMeasure {
  const char* name;
  double ShirtMeasures::*field;
  double low, high;
  const char* unit;  ///< for messages: " m", " rad"
  /// What it usually is where it is not known; none: it has to be known.
  double (*usual)(const ShirtMeasures&) = nullptr;
};
const std::vector<ShirtMeasure>& shirt_measure_list();

/// With the usual values of all that follow from others.
ShirtMeasures with_usual_measures(ShirtMeasures measures);

/// A number of ShirtFit with its name; those that may be absent are not among them.
struct ShirtFitValue {
  const char* name;
  double ShirtFit::*field;
};
const std::vector<ShirtFitValue>& shirt_fit_list();
/// A number of ShirtFit that may be absent.
struct ShirtFitOption {
  const char* name;
  std::optional<double> ShirtFit::*field;
};
const std::vector<ShirtFitOption>& shirt_fit_options();

/// The same as named values and back; of a missing one the value of `otherwise` stays, and measures
/// that follow from others follow from them.
ShirtMeasures shirt_measures_of(const BodyMeasures& values, const ShirtMeasures& otherwise = {});
ShirtFit shirt_fit_of(const NamedValues& values, const ShirtFit& otherwise = {});
BodyMeasures named(const ShirtMeasures& measures);
NamedValues named(const ShirtFit& fit);

/// A piece of the draft.
struct ShirtPart {
  const char* name;
  bool sleeve, back;
  int side;           ///< of a sleeve: +1 left, −1 right
  bool band = false;  ///< a cuff if of a sleeve, otherwise a neckband
};
/// In the order of the draft, which may leave out bands.
const std::vector<ShirtPart>& shirt_parts();
/// By Panel::part; nullptr for what is no piece of a shirt.
const ShirtPart* find_shirt_part(const std::string& name);

}  // namespace loosefit::kinds

#pragma once
#include <map>
#include <optional>
#include <string>

#include "loosefit/pattern/pattern.h"

namespace loosefit {

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

/// Girth of the arm at a share of the way from the shoulder point to the wrist [m]: that of the
/// upper arm to half way, above the elbow, then even down to the wrist (forearms are nearly cones).
double arm_girth_at(const ShirtMeasures& measures, double share);

/// What the draft arrived at.
struct ShirtDraftReport {
  double armhole = 0;        ///< front + back armhole length of one side [m]
  double armhole_depth = 0;  ///< d [m]
  double cap_height = 0;     ///< h [m]
  double cap_ratio = 0;      ///< h / d
  double front_share = 0;    ///< q, share of the sleeve girth in its front half
  double deepened = 0;  ///< underarm lowered (+) or raised (−) against armpit + scye ease [m]
  double dropped = 0;   ///< shoulder widened beyond the fit [m]
};

/// Where the flat pieces are placed in space for other tools (ours arranges them on the body).
struct ShirtPlacement {
  double hps_height = 0;  ///< high point shoulder above the floor [m]; 0 = 3.3 hps_to_waist
  double arm_abduction = 0.4363323129985824;  ///< upper arm to the downward vertical [rad]; 25°
};

/// Knit shirt, long-sleeved or with shorter sleeves, of six pieces and twelve seams with the asked
/// girths exactly (docs/theory/patterns.md). Pieces: front, back, sleeve_L_front, sleeve_L_back,
/// sleeve_R_front, sleeve_R_back; torso edges hem, side_*, armhole_*, shoulder_*, neck; sleeve
/// edges top, cuff, under, cap. \throws InvalidInput when a size or fit is outside its range, or no
/// sleeve fits the armhole (ShirtRefusal, shirt_refusal.h).
Pattern draft_shirt(const ShirtMeasures& measures, const ShirtFit& fit = {},
                    ShirtDraftReport* report = nullptr, const ShirtPlacement& placement = {});

/// Whether a sleeve of the asked girth fits the armhole when it is cut as deep as the draft goes.
bool sleeve_fits_armhole(const ShirtMeasures& measures, const ShirtFit& fit);

/// Girths of a shirt with the edge names above, measured on its pieces [m]: chest, hip (hem),
/// sleeve, wrist, waist (at `hps_to_waist` below the high point shoulder). Missing pieces are left
/// out.
std::map<std::string, double> shirt_girths(const Pattern& shirt, double hps_to_waist);

}  // namespace loosefit

#pragma once
#include "loosefit/kinds/shirt/shirt_placement.h"
#include "loosefit/kinds/shirt/shirt_values.h"
#include "loosefit/pattern/pattern.h"

namespace loosefit::kinds {

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

/// Knit shirt, long-sleeved or with shorter sleeves, of six pieces and twelve seams with the asked
/// girths exactly (docs/theory/patterns.md). Pieces: front, back, sleeve_L_front, sleeve_L_back,
/// sleeve_R_front, sleeve_R_back; torso edges hem, side_*, armhole_*, shoulder_*, neck; sleeve
/// edges top, cuff, under, cap. Darts (bust_dart.h, elbow_dart.h) and those of the back
/// (back_waist.h) add edges and seams. \throws InvalidInput when a size or fit is outside its
/// range, or no sleeve fits the armhole (ShirtRefusal, shirt_refusal.h).
pattern::Pattern draft_shirt(const ShirtMeasures& measures, const ShirtFit& fit = {},
                             ShirtDraftReport* report = nullptr,
                             const ShirtPlacement& placement = {});

/// Whether a sleeve of the asked girth fits the armhole when it is cut as deep as the draft goes.
bool sleeve_fits_armhole(const ShirtMeasures& measures, const ShirtFit& fit);

}  // namespace loosefit::kinds

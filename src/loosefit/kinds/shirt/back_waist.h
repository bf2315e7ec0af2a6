#pragma once
#include <optional>

#include "loosefit/kinds/shirt/shirt_values.h"
#include "loosefit/pattern/curve_chain.h"
#include "loosefit/pattern/pattern.h"

namespace loosefit::kinds {

// The shaped middle of a back (Aldrich 2008; docs/theory/patterns.md 6): a seam from the hem up to
// below the level of the underarms, which takes in most at the waist. Edges of the back: legs
// back_seam_L and back_seam_R, which are sewn to each other, and hem_L and hem_R.

/// Room that the seam needs [m]: its tip below the underarm, the waist below that and above the
/// hem.
inline constexpr double kBackTipDrop = 0.02, kBackTipToWaist = 0.06, kBackWaistToHem = 0.05;

/// What the seam takes in at the waist [m]: what is asked for; 0 below the least that is sewn, 5
/// mm.
double back_waist_intake(const ShirtFit& fit);
/// From leg to leg at the hem [m], which the side seams give back: a fifth of the intake and at
/// least 4 mm, so that the two parts of the hem do not touch in the flat pattern; 0 without an
/// intake.
double back_hem_mouth(double intake);

/// Levels of the middle of a back, y upwards, and half of what is taken in there [m].
struct BackSeam {
  double underarm_y = 0, waist_y = 0, hem_y = 0;
  double at_waist = 0, at_hem = 0;
};
/// The leg at x ≥ 0, hem → tip: upright at hem, waist and tip, so that the sewn cloth has no corner
/// at the hem and no spike at the tip.
pattern::CurveChain draft_back_seam(const BackSeam& seam);

/// What the seam takes out of a back piece at a level [m]; 0 beyond its ends and without one.
double back_seam_takes(const pattern::Panel& back, double y);

/// The hem of a front or back, in one part or in two.
struct BodyHem {
  double girth = 0;    ///< straight from side to side without the mouth of the seam [m]
  double highest = 0;  ///< y of its highest end or middle [m]
};
/// Nothing for a piece without a hem.
std::optional<BodyHem> body_hem(const pattern::Panel& piece);

}  // namespace loosefit::kinds

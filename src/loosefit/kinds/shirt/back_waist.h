#pragma once
#include <optional>

#include "loosefit/kinds/shirt/shirt_values.h"
#include "loosefit/pattern/curve_chain.h"
#include "loosefit/pattern/pattern.h"

namespace loosefit::kinds {

// Back waist darts (Aldrich 2008; docs/theory/patterns.md 6): one to each side below the shoulder
// blade, open at the hem, which take in most at the waist. Edges of the back: hem_L, hem and hem_R,
// and the legs back_dart_L_outer, back_dart_L_inner, …, which are sewn to each other.

/// Room that a dart needs [m]: its tip below the underarm, the waist below that and above the
/// hem.
inline constexpr double kBackTipDrop = 0.02, kBackTipToWaist = 0.06, kBackWaistToHem = 0.05;

/// What both darts take in at the waist [m]: what is asked for; 0 below the least that is sewn, 5
/// mm.
double back_waist_intake(const ShirtFit& fit);
/// What both darts take out of the hem [m], which the side seams give back: a fifth of the intake
/// and at least 8 mm, so that the parts of the hem do not touch in the flat pattern; 0 without an
/// intake.
double back_hem_mouth(double intake);

/// Levels of a dart of the right half of a back, y upwards, and half of what it takes there [m].
struct BackDart {
  double middle = 0;  ///< x of its middle line
  double tip_y = 0, waist_y = 0, hem_y = 0;
  double at_waist = 0, at_hem = 0;
};
/// The leg away from the middle of the back, hem → tip: upright at hem, waist and tip, so that the
/// sewn cloth has no corner at the hem and no spike at the tip. The other one is its mirror image.
pattern::CurveChain draft_back_dart(const BackDart& dart, bool outer);

/// What the darts take out of a back piece at a level [m]; 0 beyond their ends and without them.
double back_darts_take(const pattern::Panel& back, double y);

/// The hem of a front or back, in one part or in three.
struct BodyHem {
  double girth = 0;    ///< straight from side to side without the mouths of darts [m]
  double highest = 0;  ///< y of its highest end or middle [m]
};
/// Nothing for a piece without a hem.
std::optional<BodyHem> body_hem(const pattern::Panel& piece);

}  // namespace loosefit::kinds

#pragma once
#include "loosefit/kinds/named_values.h"
#include "loosefit/pattern/curve_chain.h"

namespace loosefit::kinds {

/// The thigh level lies at least this far below the end of the crotch curve [m].
inline constexpr double kBelowTip = 0.005;

/// Outline of one piece of a leg, the front or the back, flat: x across from its crease line [m],
/// the outseam at positive x; y the height above the floor [m]. Counter-clockwise they are hem,
/// outseam backwards, waist, centre, inseam, each beginning where the last one ends. Outseam and
/// inseam have a knot at every level of the leg, the outseam at the hip too.
struct Leg {
  pattern::CurveChain hem;      ///< inner → outer end
  pattern::CurveChain outseam;  ///< waist → hem
  pattern::CurveChain waist;    ///< outer end → centre
  pattern::CurveChain centre;   ///< waist → crotch
  pattern::CurveChain inseam;   ///< crotch → hem
};

/// What draft_leg moves of its own to make the seams of front and back as long as each other [m];
/// all 0: nothing is moved. ease_legs (trousers_seams.h) finds the values.
struct Easing {
  double side_rise = 0;      ///< the outer end of the back's waist, up
  double crotch_drop = 0;    ///< the end of the back's crotch curve, down
  double thigh_to_back = 0;  ///< width at the thigh that the front gives to the back
};

/// Whether the leg is cut to a girth at the thigh: `fit` has one, and the thigh level lies at least
/// kBelowTip below the crotch of the trousers and 5 cm above the next level below it, knee or hem.
/// \pre as draft_leg
bool has_thigh_level(const BodyMeasures& measures, const NamedValues& fit);

/// The front or the back of a leg, cut to the girths of `fit` at hip, thigh, knee, calf and hem,
/// each piece its share of them (kFrontShare) but for what `easing` gives. Outseam and inseam are
/// smooth (monotone cubics, Fritsch and Carlson 1980); the centre seam runs straight down from the
/// waist and then round to the end of the crotch curve, level there. Knee and calf are left out
/// below the hem and up to 3 cm above it, a thigh as has_thigh_level says.
/// \pre `measures` has hip, waist, waist_level, hip_level and crotch_height, `fit` every key of the
/// kind but thigh and calf, and the two make a garment together: nothing of that is checked here
/// (trousers_draft.h).
/// \throws std::out_of_range for a name that is missing.
Leg draft_leg(const BodyMeasures& measures, const NamedValues& fit, bool front,
              const Easing& easing);

}  // namespace loosefit::kinds

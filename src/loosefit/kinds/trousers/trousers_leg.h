#pragma once
#include "loosefit/kinds/named_values.h"
#include "loosefit/pattern/curve_chain.h"

namespace loosefit::kinds {

/// Thigh level, below the end of the crotch curve, at least [m].
inline constexpr double kBelowTip = 0.005;

/// One piece of a leg about its crease line x = 0, y the height above the floor [m], its outseam at
/// positive x.
struct Leg {
  pattern::CurveChain hem;      ///< inner → outer end
  pattern::CurveChain outseam;  ///< waist → hem
  pattern::CurveChain waist;    ///< outer end → centre
  pattern::CurveChain centre;   ///< waist → crotch
  pattern::CurveChain inseam;   ///< crotch → hem
};

/// What the seams of front and back are made as long as each other with [m].
struct Easing {
  double side_rise = 0;      ///< of the outer end of the back's waist
  double crotch_drop = 0;    ///< of the end of the back's crotch curve
  double thigh_to_back = 0;  ///< width at the thigh that the front gives to the back
};

/// Whether the leg is cut to a girth at the thigh: it was asked for, and lies below the crotch and
/// well above the next level of the leg.
bool has_thigh_level(const NamedValues& measures, const NamedValues& fit);

/// The front or the back of a leg. \pre the measures go together (draft_trousers)
Leg draft_leg(const NamedValues& measures, const NamedValues& fit, bool front,
              const Easing& easing);

}  // namespace loosefit::kinds

#pragma once
#include <set>
#include <string>

#include "loosefit/kinds/trousers/trousers_leg.h"

namespace loosefit::kinds {

/// The easing [m] with which inseam and outseam of the back are as long as those of the front, or
/// as close to that as it may bring them. The back's crotch curve reaches farther under the body:
/// its inseam is shortened by a lower end of that curve, by up to 20 mm, and where the thigh leaves
/// too little room for that, by a back that is wider there and a front that is narrower, as
/// trousers are cut; the girth stays, and either has at least three tenths of it. On legs without a
/// girth at the thigh (has_thigh_level) the end of the curve alone moves, by up to 50 mm. Outseams
/// are made equal by the outer end of the back's waist, up to 50 mm higher or lower.
/// \pre as draft_leg (trousers_leg.h). Whether the seams close is for check_seams to say.
Easing ease_legs(const BodyMeasures& measures, const NamedValues& fit);

/// Refuses legs of which a seam is longer behind than in front, or shorter, by 2 mm or more, which
/// is not sewn in unseen. `easing`: that of ease_legs; `asked`: keys of the fit that somebody asked
/// for, without "fit.".
/// \throws InvalidInput with place fit.crotch_width or fit.hip, one that was asked for where it
/// can, and a lower value of it, in thousandths, with which the seams close; with fit.leg_length
/// where there is no such value.
void check_seams(const BodyMeasures& measures, const NamedValues& fit, const Easing& easing,
                 const std::set<std::string>& asked);

}  // namespace loosefit::kinds

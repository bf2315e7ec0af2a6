#pragma once
#include <set>
#include <string>

#include "loosefit/kinds/trousers/trousers_leg.h"

namespace loosefit::kinds {

/// The easing with which the seams of the back are as long as those of the front, or as close to
/// that as it may bring them. The back's crotch curve reaches farther under the body: its inseam is
/// shortened by a lower end of that curve, and where the thigh leaves too little room for that, by
/// a back that is wider there and a front that is narrower, as trousers are cut; the girth stays.
Easing ease_legs(const NamedValues& measures, const NamedValues& fit);

/// \throws InvalidInput for legs of which a seam is longer behind than in front, or shorter, by
/// more than is sewn in unseen, 2 mm; with a key that was asked for, where there is one. `asked`:
/// "hip", …
void check_seams(const NamedValues& measures, const NamedValues& fit, const Easing& easing,
                 const std::set<std::string>& asked);

}  // namespace loosefit::kinds

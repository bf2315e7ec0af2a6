#pragma once
#include <map>
#include <string>

#include "loosefit/kinds/kind.h"

namespace loosefit::kinds {

/// The measures of a body (Body::measured) that a kind of garment asks for and that are known, with its
/// girths along its limbs.
BodyMeasures known_measures(const GarmentKind& kind, const std::map<std::string, double>& measured,
                            const GirthsAlong& along = {});

/// All of them. \throws InvalidInput naming a missing one.
BodyMeasures draft_measures(const GarmentKind& kind, const std::map<std::string, double>& measured,
                            const GirthsAlong& along = {});

}  // namespace loosefit::kinds

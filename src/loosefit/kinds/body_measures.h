#pragma once
#include <map>
#include <string>

#include "loosefit/kinds/kind.h"

namespace loosefit::kinds {

/// The measures of a body (Body::measured) that a kind of garment asks for and that are known.
NamedValues known_measures(const GarmentKind& kind, const std::map<std::string, double>& measured);

/// All of them. \throws InvalidInput naming a missing one.
NamedValues draft_measures(const GarmentKind& kind, const std::map<std::string, double>& measured);

}  // namespace loosefit::kinds

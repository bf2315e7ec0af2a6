#pragma once
#include <string>
#include <vector>

#include "loosefit/pattern/shirt_draft.h"

namespace loosefit {

/// Names of the garments that the shirt draft makes, the usual one first.
const std::vector<std::string>& shirt_kinds();

/// The fit that a shirt of this kind has where nothing else is asked for: the only place of these
/// defaults, for scenarios and for the command line. A "t-shirt" has short sleeves.
ShirtFit usual_fit(const std::string& kind);

}  // namespace loosefit

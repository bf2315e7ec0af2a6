#pragma once
#include <vector>

#include "loosefit/kinds/kind.h"

namespace loosefit::kinds {

/// \throws InvalidInput, key "measures.NAME" or "fit.NAME", for the first measure that is missing
/// or that people do not have, and the first key that is beyond its range.
void check_values(const std::vector<KindMeasure>& measures, const NamedValues& body,
                  const std::vector<KindKey>& keys, const NamedValues& fit);

}  // namespace loosefit::kinds

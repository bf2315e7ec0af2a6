#pragma once
#include <string>
#include <vector>

#include "loosefit/kinds/kind.h"

namespace loosefit::kinds {

/// All kinds of garments, the usual one first: the only list of them.
const std::vector<GarmentKind>& garment_kinds();

/// By name. \throws InvalidInput, key "pattern", with a did-you-mean.
const GarmentKind& garment_kind(const std::string& name);

/// Names of the kinds that can be drafted.
std::vector<std::string> drafted_kinds();

}  // namespace loosefit::kinds

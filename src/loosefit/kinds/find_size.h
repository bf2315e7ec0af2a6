#pragma once
#include <string>
#include <vector>

#include "loosefit/kinds/kind.h"

namespace loosefit::kinds {

/// By name, any letter case. \throws InvalidInput, key "size", with a did-you-mean.
const KindSize& find_size(const std::vector<KindSize>& sizes, const std::string& name);
/// All names, for lists and did-you-mean.
std::vector<std::string> size_names(const std::vector<KindSize>& sizes);

}  // namespace loosefit::kinds

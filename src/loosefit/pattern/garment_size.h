#pragma once
#include <optional>
#include <string>
#include <vector>

#include "loosefit/pattern/shirt_draft.h"

namespace loosefit {

/// A fixed shirt: the standard body it is cut for and its ease. One garment for all bodies.
struct GarmentSize {
  std::string name;    ///< "child-142", "women-38", "men-M", …
  ShirtMeasures body;  ///< the size table's body
  ShirtFit fit;
  std::string source;  ///< where the numbers come from and how sure they are
};

/// By name, any letter case; empty if there is none.
std::optional<GarmentSize> garment_size(const std::string& name);
/// All names, for lists and did-you-mean.
std::vector<std::string> garment_size_names();

}  // namespace loosefit

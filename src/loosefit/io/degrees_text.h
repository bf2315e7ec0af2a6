#pragma once
#include <string>

namespace loosefit {

/// Shortest degrees that read back to the same radians.
std::string degrees_text(double angle);

}  // namespace loosefit

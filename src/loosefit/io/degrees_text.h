#pragma once
#include <string>

namespace loosefit::io {

/// Shortest degrees that read back to the same radians.
std::string degrees_text(double angle);

}  // namespace loosefit::io

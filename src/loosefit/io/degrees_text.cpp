#include "loosefit/io/degrees_text.h"

#include <fmt/format.h>

#include "loosefit/base/text.h"
#include "loosefit/base/types.h"

namespace loosefit::io {

// Angles are kept in radians; print the degrees that read back to the same radians.
std::string degrees_text(double angle) {
  for (int digits = 1; digits <= 17; ++digits) {
    const std::string text = fmt::format("{:.{}g}", degrees(angle), digits);
    if (radians(std::stod(text)) == angle) return shortest(std::stod(text));
  }
  return shortest(degrees(angle));
}

}  // namespace loosefit::io

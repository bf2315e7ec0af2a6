#include "standard_error.h"

#include <cstdio>

namespace loosefit {

void to_standard_error(std::string_view text) noexcept {
  std::fwrite(text.data(), 1, text.size(), stderr);
}

}  // namespace loosefit

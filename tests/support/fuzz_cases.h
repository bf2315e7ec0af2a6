#pragma once
#include <cstdlib>

namespace loosefit {

/// How many damaged files a test tries: so many, or LOOSEFIT_FUZZ_CASES for the long run under
/// sanitizers.
inline unsigned fuzz_cases(unsigned usual) {
  const char* asked = std::getenv("LOOSEFIT_FUZZ_CASES");
  return asked ? static_cast<unsigned>(std::atol(asked)) : usual;
}

}  // namespace loosefit

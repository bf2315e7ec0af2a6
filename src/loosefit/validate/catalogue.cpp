#include "loosefit/validate/catalogue.h"

namespace loosefit {

std::vector<Benchmark> benchmarks() { return {}; }

}  // namespace loosefit

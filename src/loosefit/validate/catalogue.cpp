#include "loosefit/validate/catalogue.h"

namespace loosefit {

std::vector<Benchmark> benchmarks() {
  return {
      {"D1", "Cusick drape of an elastic sheet", "validation.md 5.3: energy minima with hinges", true,
       benchmark_cusick_drape},
  };
}

}  // namespace loosefit

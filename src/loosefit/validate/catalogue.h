#pragma once
#include "loosefit/validate/benchmark.h"

namespace loosefit {

// One function per benchmark, each in the file of its group; catalogue.cpp puts them in order.

BenchmarkResult benchmark_cusick_drape(Effort effort, Progress& progress);

}  // namespace loosefit

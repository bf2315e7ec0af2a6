#pragma once
#include <string>
#include <vector>

#include "loosefit/validate/benchmark.h"
#include "loosefit/validate/run_validation.h"

namespace loosefit::validate {

/// validation.json; keys in docs/outputs.md. Numbers that are not finite are null.
std::string validation_json(const Validation& validation);

/// What there is to carry out: `benchmarks[]` with id, title, reference and in_quick.
std::string benchmarks_json(const std::vector<Benchmark>& list);

}  // namespace loosefit::validate

#pragma once
#include <functional>
#include <string>
#include <vector>

#include "loosefit/base/progress.h"
#include "loosefit/validate/benchmark.h"

namespace loosefit::validate {

/// What became of one benchmark.
struct BenchmarkOutcome {
  std::string id, title, reference;
  BenchmarkResult result;
  std::string error;   ///< why it could not be carried out; empty when it could
  double seconds = 0;  ///< wall time

  /// It has something to pass: a gated finding, or it failed to find anything.
  bool gated() const;
  /// The gravest verdict of its findings; a miss when it could not be carried out or found nothing.
  Verdict verdict() const;
};

/// All benchmarks of one call, in the order of the list.
struct Validation {
  Effort effort = Effort::full;
  std::vector<BenchmarkOutcome> outcomes;
  double seconds = 0;  ///< wall time of the whole

  int gated() const;
  int count(Verdict verdict) const;  ///< benchmarks with this verdict
  /// Every benchmark is as stated: it passes, is reported, or misses what is known to be missed.
  bool as_stated() const;
};

/// The benchmarks of `all` with these ids (in any case), in the order of `all`; no ids: all of
/// them. Effort::quick leaves out those without a quick form. \throws InvalidInput for an id that
/// is unknown or, asked for by name, has no quick form.
std::vector<Benchmark> select_benchmarks(const std::vector<Benchmark>& all,
                                         const std::vector<std::string>& ids, Effort effort);

/// Runs benchmarks on up to `workers` threads, each benchmark on one of them alone: no result
/// depends on the number of workers. A benchmark that throws is recorded and the others go on.
/// `finished` (may be empty) is called once per benchmark, in the order of the list, never twice at
/// a time. \throws Cancelled as `progress` asks.
Validation run_validation(const std::vector<Benchmark>& benchmarks, Effort effort,
                          Progress& progress, int workers,
                          const std::function<void(const BenchmarkOutcome&)>& finished = {});

}  // namespace loosefit::validate

#pragma once
#include <stdexcept>
#include <utility>

#include "loosefit/validate/benchmark.h"

namespace loosefit::support {

inline validate::Finding finding(double expected, double obtained, validate::Finding::Gate gate,
                                 double limit) {
  validate::Finding f;
  f.what = "length <of> & thread";
  f.unit = "mm";
  f.expected = expected;
  f.obtained = obtained;
  f.gate = gate;
  f.limit = limit;
  f.mesh = "no mesh";
  return f;
}

inline validate::Benchmark with_findings(const std::string& id,
                                         std::vector<validate::Finding> findings) {
  return {id, "Artificial", "made up", true, [findings](validate::Effort, Progress& progress) {
            progress.update(0.5, "half");
            validate::BenchmarkResult result;
            result.findings = findings;
            return result;
          }};
}

/// A1 passes, A2 misses one of two gates, A3 only reports, A4 throws, A5 finds nothing and has no
/// quick form.
inline std::vector<validate::Benchmark> artificial_benchmarks() {
  const validate::Finding good = finding(1, 1.001, validate::Finding::Gate::relative, 0.01);
  const validate::Finding bad = finding(1, 1.1, validate::Finding::Gate::relative, 0.01);
  const validate::Finding told = finding(1, 7, validate::Finding::Gate::reported, 0);
  std::vector<validate::Benchmark> all = {
      with_findings("A1", {good}), with_findings("A2", {good, bad}), with_findings("A3", {told}),
      with_findings("A4", {}), with_findings("A5", {})};
  all[3].run = [](validate::Effort, Progress&) -> validate::BenchmarkResult {
    throw std::runtime_error("the loom broke");
  };
  all[4].in_quick = false;
  return all;
}

}  // namespace loosefit::support

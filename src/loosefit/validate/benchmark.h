#pragma once
#include <functional>
#include <string>
#include <vector>

#include "loosefit/base/progress.h"
#include "loosefit/report/plot.h"

namespace loosefit::validate {

/// One figure held against its reference.
struct Finding {
  enum class Gate {
    relative,  ///< |obtained − expected| / |expected| ≤ limit
    absolute,  ///< |obtained − expected| ≤ limit, in the unit of the figure
    reported,  ///< no gate: stated for the reader
  };
  std::string what;  ///< "H/W at Γ = 8"
  std::string unit;  ///< "mm", "°"; empty for pure numbers
  double expected = 0, obtained = 0;
  Gate gate = Gate::relative;
  double limit = 0;  ///< relative: a fraction
  std::string mesh;  ///< "5 mm edges, 1 240 triangles"

  double error() const;  ///< in the measure of the gate
  bool pass() const;     ///< false also when `obtained` is not finite
};

/// What one benchmark found.
struct BenchmarkResult {
  std::vector<Finding> findings;
  std::vector<report::Plot> plots;
  std::vector<std::string> notes;  ///< what a sceptical reader has to know
};

/// quick: the subset that fits into a test run; full: all rows that the benchmark's own file holds.
enum class Effort { quick, full };

/// One entry of the benchmark list of docs/theory/validation.md 0; B9 is added to it (2.3).
struct Benchmark {
  std::string id;         ///< "B1"
  std::string title;      ///< "Heavy cantilever"
  std::string reference;  ///< where the expected figures come from
  bool in_quick = true;   ///< has a quick form
  /// Calls progress.update(fraction, note) at least every few seconds of work and
  /// progress.check_cancelled().
  std::function<BenchmarkResult(Effort, Progress&)> run;
};

/// All benchmarks in the order of the list.
std::vector<Benchmark> benchmarks();

}  // namespace loosefit::validate

#pragma once
#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "loosefit/base/progress.h"
#include "loosefit/report/plot.h"

namespace loosefit::validate {

/// What became of a figure, or of the figures of a benchmark together: the gravest of them.
enum class Verdict {
  reported,         ///< no gate
  pass,             ///< meets its gate
  known_miss,       ///< misses its gate as stated, by no more than stated, for a stated reason
  unexpected_pass,  ///< is stated to miss, and meets its gate: the statement is out of date
  miss,             ///< misses its gate, or by more than stated, or is not finite
};

/// "pass", "MISS", "known miss", "unexpected pass", "reported".
std::string name(Verdict verdict);

/// Whether it is as the code says it is: neither a miss nor an unexpected pass.
bool is_as_stated(Verdict verdict);

/// A gate that is known to be missed. It stays a gate: that it is missed is shown, and more than
/// `most` is a miss like any other.
struct KnownMiss {
  double most = 0;     ///< largest error, in the measure of the gate, that is still this miss
  std::string reason;  ///< why, as far as it is known
};

/// One figure held against its reference.
struct Finding {
  enum class Gate {
    relative,  ///< |obtained − expected| / |expected| ≤ limit
    absolute,  ///< |obtained − expected| ≤ limit, in the unit of the figure
    range,     ///< low ≤ obtained ≤ high; the error is how far outside it lies
    reported,  ///< no gate: stated for the reader
  };
  std::string what;  ///< "H/W at Γ = 8"
  std::string unit;  ///< "mm", "°"; empty for pure numbers
  double expected = 0, obtained = 0;
  Gate gate = Gate::relative;
  double limit = 0;                         ///< relative: a fraction; no meaning for a range
  std::string mesh;                         ///< "5 mm edges, 1 240 triangles"
  double low = -HUGE_VAL, high = HUGE_VAL;  ///< of the range; an open end is infinite
  std::optional<KnownMiss> known_miss = {};

  double error() const;  ///< in the measure of the gate
  /// 0 at the expected figure, or in the middle of a range, 1 at the gate, more beyond it.
  double share_of_gate() const;
  bool pass() const;  ///< meets its gate; false also when `obtained` is not finite
  Verdict verdict() const;
};

/// A figure that has to lie between `low` and `high` (either may be infinite). `expected` is what
/// the source says, NaN where it says no more than the range.
Finding in_range(std::string what, std::string unit, double expected, double obtained, double low,
                 double high, std::string mesh);

/// How many of `all` things are as they ought to be, which is all of them. As many as `wrong` are
/// known not to be, for `reason`; 0: none. \throws Error unless that is fewer than all: else no
/// count at all could be a miss.
Finding whole_count(std::string what, int all, int obtained, std::string mesh, int wrong = 0,
                    std::string reason = {});

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

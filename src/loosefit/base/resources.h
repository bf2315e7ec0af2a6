#pragma once
#include <tbb/global_control.h>

#include <optional>

namespace loosefit {

/// Largest resident memory of this process so far [MB = 10⁶ bytes]; 0 where it cannot be asked.
double peak_memory_mb();
/// Memory that this process may take: that of the machine, or of its control group where that is
/// less [MB = 10⁶ bytes]; 0 where it cannot be asked.
double usable_memory_mb();

/// Threads that may work at the same time here.
int usable_threads();

/// While it lives, no more than this many threads work in the process; 0: as many as there are.
class ThreadLimit {
 public:
  explicit ThreadLimit(int threads);

 private:
  std::optional<tbb::global_control> limit_;
};

}  // namespace loosefit

#pragma once
#include <tbb/global_control.h>

namespace loosefit {

/// Largest resident memory of this process so far [MB = 10⁶ bytes]; 0 where it cannot be asked.
double peak_memory_mb();
/// Memory that this process may take: that of the machine, or of its control groups or limits
/// (RLIMIT_AS, RLIMIT_DATA) where that is less [MB = 10⁶ bytes]; 0 where it cannot be asked.
double usable_memory_mb();

/// Cores that this process may use: those of its affinity, or what its control groups let it have
/// of them, rounded up, where that is less.
int allowed_cores();
/// Threads that may work at the same time here: one for each allowed core, unless a ThreadLimit is
/// lower.
int usable_threads();

/// While it lives, no more than this many threads work in the process, and no more than there are
/// allowed cores; 0: as many as those.
class ThreadLimit {
 public:
  explicit ThreadLimit(int threads);

 private:
  tbb::global_control limit_;
};

}  // namespace loosefit

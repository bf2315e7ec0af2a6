#include "loosefit/base/resources.h"

#include <sched.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <thread>
#include <vector>

#include "loosefit/base/control_groups.h"

namespace loosefit {
namespace {

/// Cores of the affinity of this process; those of the machine where it cannot be asked.
int cores_of_affinity() {
  constexpr std::size_t kMost = 1 << 16;  // a set of this many is always large enough
  std::vector<cpu_set_t> set(CPU_ALLOC_SIZE(kMost) / sizeof(cpu_set_t));
  const std::size_t bytes = set.size() * sizeof(cpu_set_t);
  const int count =
      sched_getaffinity(0, bytes, set.data()) == 0 ? CPU_COUNT_S(bytes, set.data()) : 0;
  return std::max(1, count > 0 ? count : static_cast<int>(std::thread::hardware_concurrency()));
}

}  // namespace

double peak_memory_mb() {
  rusage usage{};
  if (getrusage(RUSAGE_SELF, &usage) != 0) return 0;
  return static_cast<double>(usage.ru_maxrss) * 1024 / 1e6;  // Linux counts in KiB
}

double usable_memory_mb() {
  const long pages = sysconf(_SC_PHYS_PAGES), size = sysconf(_SC_PAGESIZE);
  if (pages <= 0 || size <= 0) return 0;
  double bytes = static_cast<double>(pages) * static_cast<double>(size);
  for (const auto resource : {RLIMIT_AS, RLIMIT_DATA})
    if (rlimit limit{}; getrlimit(resource, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY)
      bytes = std::min(bytes, static_cast<double>(limit.rlim_cur));
  return std::min(bytes, group_limits().memory_bytes.value_or(bytes)) / 1e6;
}

int allowed_cores() {
  const int cores = cores_of_affinity();
  const double share = group_limits().cores.value_or(cores);
  return std::clamp(static_cast<int>(std::ceil(share)), 1, cores);
}

int usable_threads() {
  const std::size_t limit =
      tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
  return static_cast<int>(std::min(limit, static_cast<std::size_t>(allowed_cores())));
}

ThreadLimit::ThreadLimit(int threads)
    : limit_(tbb::global_control::max_allowed_parallelism,
             static_cast<std::size_t>(threads > 0 ? std::min(threads, allowed_cores())
                                                  : allowed_cores())) {}

}  // namespace loosefit

#include "loosefit/study/drapes_at_once.h"

#include <algorithm>

#include "loosefit/base/resources.h"

namespace loosefit {
namespace {

/// Of the memory that there is, that drapes side by side may take.
constexpr double kMemoryShare = 0.5;

}  // namespace

int drapes_at_once() {
  const double peak = peak_memory_mb(), all = usable_memory_mb();
  const double room = peak > 0 && all > 0 ? kMemoryShare * all / peak : 1;
  return std::max(1, static_cast<int>(std::min(room, static_cast<double>(usable_threads()))));
}

}  // namespace loosefit

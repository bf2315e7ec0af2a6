#include "loosefit/base/progress.h"

#include "loosefit/base/error.h"

namespace loosefit {

void Progress::check_cancelled() const {
  if (cancelled_.load(std::memory_order_relaxed)) throw Cancelled();
}

}  // namespace loosefit

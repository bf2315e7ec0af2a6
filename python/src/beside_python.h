#pragma once
#include <pybind11/pybind11.h>

#include <atomic>
#include <functional>

#include "loosefit/base/progress.h"

namespace loosefit::python {

/// Asks work to stop, from any thread.
class CancelToken {
 public:
  void cancel() { cancelled_.store(true, std::memory_order_relaxed); }
  bool cancelled() const { return cancelled_.load(std::memory_order_relaxed); }

 private:
  std::atomic<bool> cancelled_{false};
};

/// Does long work in a thread of its own, without the GIL, while the calling thread looks after
/// Python: twenty times a second it lets signals be handled (in the main thread, as Python does),
/// and calls `progress(stage, fraction)`, unless it is None, always from the calling thread. So no
/// thread of ours ever waits for the GIL, and a callback may do what it likes.
///
/// The work is asked to stop, and waited for, when a signal handler or the callback raises (that
/// exception is then thrown), when the callback returns False, and when `token`, unless null, was
/// cancelled (Cancelled is then thrown). Else what the work throws is thrown.
void beside_python(const pybind11::object& progress, const CancelToken* token,
                   const std::function<void(Progress&)>& work);

}  // namespace loosefit::python

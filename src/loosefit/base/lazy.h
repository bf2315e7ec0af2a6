#pragma once
#include <tbb/task_arena.h>

#include <memory>
#include <mutex>

namespace loosefit {

/// A value that is made when it is first asked for, and kept. Any number of threads may ask at
/// once: one of them makes it, the others wait for it. What `make` throws is passed on, and the
/// next one who asks tries again.
template <class T>
class Lazy {
 public:
  /// make() returns a T; it is called once.
  template <class Make>
  const T& get(const Make& make) const {
    std::call_once(once_, [&] {
      // Isolated: while this thread waits for those who help it make the value, it must not begin
      // another task, which might ask for the same value.
      tbb::this_task_arena::isolate([&] { value_.reset(new T(make())); });
    });
    return *value_;
  }

 private:
  mutable std::once_flag once_;
  mutable std::unique_ptr<const T> value_;
};

}  // namespace loosefit

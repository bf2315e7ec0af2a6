#pragma once
#include <algorithm>

namespace loosefit {

/// When to try again what may fail: each failure in a row doubles the wait before the next try.
class Backoff {
 public:
  /// most: tries that are left out in a row, at most.
  explicit Backoff(int most) : most_(most) {}
  /// Whether it is time; otherwise one try less is to be left out.
  bool ready() {
    if (wait_ == 0) return true;
    --wait_;
    return false;
  }
  void succeeded() { next_wait_ = 1; }
  void failed() {
    wait_ = next_wait_;
    next_wait_ = std::min(most_, 2 * next_wait_);
  }

 private:
  int most_;
  int wait_ = 0, next_wait_ = 1;
};

}  // namespace loosefit

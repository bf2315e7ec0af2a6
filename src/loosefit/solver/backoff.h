#pragma once
#include <algorithm>

namespace loosefit::solver {

/// Exponential backoff: when to try again what may fail. Each failure in a row doubles the pause
/// before the next try.
class Backoff {
 public:
  /// max_pause: longest pause, in tries that are left out.
  explicit Backoff(int max_pause) : max_pause_(max_pause) {}
  /// Whether it is time; otherwise the pause is one try shorter.
  bool ready() {
    if (pause_ == 0) return true;
    --pause_;
    return false;
  }
  void succeeded() { next_pause_ = 1; }
  void failed() {
    pause_ = next_pause_;
    next_pause_ = std::min(max_pause_, 2 * next_pause_);
  }

 private:
  int max_pause_;
  int pause_ = 0, next_pause_ = 1;
};

}  // namespace loosefit::solver

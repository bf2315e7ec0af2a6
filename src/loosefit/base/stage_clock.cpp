#include "loosefit/base/stage_clock.h"

#include <algorithm>

namespace loosefit {

void StageClock::stage(const std::string& name) {
  shown_->check_cancelled();
  stop();
  const auto known = std::find_if(entries_.begin(), entries_.end(),
                                  [&](const Entry& e) { return e.stage == name; });
  running_ = static_cast<int>(known - entries_.begin());
  if (known == entries_.end()) entries_.push_back({name, 0});
  since_ = Clock::now();
  shown_->stage(name);
}

void StageClock::stop() {
  if (running_ < 0) return;
  entries_[running_].seconds += std::chrono::duration<double>(Clock::now() - since_).count();
  running_ = -1;
}

}  // namespace loosefit

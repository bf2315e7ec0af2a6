#pragma once
#include <chrono>
#include <string>
#include <vector>

#include "loosefit/base/progress.h"

namespace loosefit {

/// Progress that passes everything on to another one and times the stages it hears of, so that
/// timers, log lines and docs share one vocabulary. A stage named twice adds up.
class StageClock : public Progress {
 public:
  struct Entry {
    std::string stage;
    double seconds = 0;
  };
  explicit StageClock(Progress& shown) : shown_(&shown) {}
  void stage(const std::string& name) override;
  void update(double fraction, const std::string& note) override { shown_->update(fraction, note); }
  void check_cancelled() const override { shown_->check_cancelled(); }
  /// Ends the running stage; called again by the next stage().
  void stop();
  /// Stages in the order in which they began [s].
  const std::vector<Entry>& entries() const { return entries_; }

 private:
  using Clock = std::chrono::steady_clock;
  Progress* shown_;
  std::vector<Entry> entries_;
  int running_ = -1;
  Clock::time_point since_;
};

}  // namespace loosefit

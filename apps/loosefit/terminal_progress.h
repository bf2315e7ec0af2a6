#pragma once
#include <array>
#include <chrono>
#include <csignal>
#include <string>

#include "loosefit/base/progress.h"

namespace loosefit {

/// Progress on standard error: one line that is redrawn on a terminal, plain lines (one per stage,
/// and one every ten seconds) otherwise.
class TerminalProgress : public Progress {
 public:
  /// stage: of work that begins with no word of it, since it is mostly over at once
  explicit TerminalProgress(bool quiet, std::string stage = "");
  ~TerminalProgress() override;
  void stage(const std::string& name) override;
  void update(double fraction, const std::string& note) override;
  /// Prints a line of its own, above the bar.
  void line(const std::string& text);
  /// Removes the bar.
  void clear();

 private:
  using Clock = std::chrono::steady_clock;
  void draw(double fraction, const std::string& note);
  double seconds() const;

  bool quiet_, terminal_, drawn_ = false;
  std::string stage_;
  double furthest_ = 0;  ///< fraction of this stage
  Clock::time_point start_ = Clock::now(), last_ = start_;
};

/// While it lives, Ctrl-C (and SIGTERM, SIGHUP) asks `progress` to stop instead of ending the
/// process, so that the work can leave nothing half-written. A signal that whoever started the
/// program has it ignore (nohup; jobs of a script that run beside it) stays ignored.
class InterruptGuard {
 public:
  explicit InterruptGuard(Progress& progress);
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;

 private:
  std::array<struct sigaction, 3> before_;
};

}  // namespace loosefit

#include "terminal_progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <utility>

#include "loosefit/base/text.h"
#include "standard_error.h"

namespace loosefit {
namespace {

constexpr std::array<int, 3> kSignals = {SIGINT, SIGTERM, SIGHUP};
std::atomic<Progress*> interrupted{nullptr};
static_assert(std::atomic<Progress*>::is_always_lock_free, "used in a signal handler");

extern "C" void on_interrupt(int) {
  if (Progress* progress = interrupted.load()) progress->request_cancel();
}

std::string bar(double fraction) {
  constexpr int kWidth = 24;
  const int full = static_cast<int>(std::lround(std::clamp(fraction, 0.0, 1.0) * kWidth));
  return std::string(full, '#') + std::string(kWidth - full, '.');
}

}  // namespace

TerminalProgress::TerminalProgress(bool quiet, std::string stage)
    : quiet_(quiet), terminal_(isatty(STDERR_FILENO)), stage_(std::move(stage)) {}

TerminalProgress::~TerminalProgress() { clear(); }

double TerminalProgress::seconds() const {
  return std::chrono::duration<double>(Clock::now() - start_).count();
}

void TerminalProgress::stage(const std::string& name) {
  stage_ = name;
  furthest_ = 0;
  last_ = Clock::now();
  if (quiet_) return;
  if (terminal_)
    draw(0, "");
  else
    to_standard_error(fmt::format("{:6.1f} s  {}\n", seconds(), name));
}

void TerminalProgress::update(double fraction, const std::string& note) {
  if (quiet_) return;
  furthest_ = fraction =
      std::max(fraction, furthest_);  // residuals rise at times, a bar should not
  const auto pause = terminal_ ? std::chrono::milliseconds(100) : std::chrono::seconds(10);
  if (Clock::now() - last_ < pause) return;
  last_ = Clock::now();
  if (terminal_)
    draw(fraction, note);
  else
    to_standard_error(fmt::format("{:6.1f} s  {} {:3.0f} %  {}\n", seconds(), stage_,
                                  100 * fraction, terminal_line(note)));
}

void TerminalProgress::draw(double fraction, const std::string& note) {
  std::string shown = terminal_line(note);
  if (std::size_t end = 36; shown.size() > end) {
    while ((shown[end] & 0xc0) == 0x80) --end;  // not within a character of UTF-8
    shown.resize(end);
  }
  drawn_ = true;
  to_standard_error(fmt::format("\r\033[K{:9} [{}] {:3.0f} %  {:.0f} s  {}", stage_, bar(fraction),
                                100 * fraction, seconds(), shown));
  std::fflush(stderr);
}

void TerminalProgress::line(const std::string& text) {
  clear();
  if (!quiet_) to_standard_error(fmt::format("{}\n", terminal_line(text)));
}

void TerminalProgress::clear() {
  if (!drawn_) return;
  drawn_ = false;
  to_standard_error("\r\033[K");
  std::fflush(stderr);
}

InterruptGuard::InterruptGuard(Progress& progress) {
  interrupted.store(&progress);
  struct sigaction action = {};
  action.sa_handler = on_interrupt;
  sigemptyset(&action.sa_mask);
  action.sa_flags = SA_RESTART;
  for (std::size_t i = 0; i < kSignals.size(); ++i) {
    sigaction(kSignals[i], nullptr, &before_[i]);
    if (before_[i].sa_handler != SIG_IGN) sigaction(kSignals[i], &action, nullptr);
  }
}

InterruptGuard::~InterruptGuard() {
  for (std::size_t i = 0; i < kSignals.size(); ++i) sigaction(kSignals[i], &before_[i], nullptr);
  interrupted.store(nullptr);
}

}  // namespace loosefit

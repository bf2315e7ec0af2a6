#pragma once
#include <atomic>
#include <string>

namespace loosefit {

/// Receives progress of long work and carries the wish to stop. The base class is silent.
/// Long loops call `update` at least every second or so and `check_cancelled` every iteration.
class Progress {
 public:
  virtual ~Progress() = default;
  /// A pipeline stage begins: body, pattern, garment, dress, settle, postures, donnings, maps,
  /// placement, repeats, report.
  virtual void stage(const std::string& /*name*/) {}
  /// fraction in [0,1]; note is one short phrase ("level 2, residual 3.1e-2"). Comes from any
  /// thread, one call at a time.
  virtual void update(double /*fraction*/, const std::string& /*note*/) {}
  /// Safe to call from a signal handler.
  void request_cancel() { cancelled_.store(true, std::memory_order_relaxed); }
  /// May come from several threads at once. \throws Cancelled once request_cancel() was called.
  virtual void check_cancelled() const;

 private:
  std::atomic<bool> cancelled_{false};
};

}  // namespace loosefit

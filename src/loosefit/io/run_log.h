#pragma once
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>

#include "loosefit/base/progress.h"

namespace loosefit::io {

/// log.jsonl of a run: one JSON object per line with `seconds` since the start, `event` (stage,
/// progress, warning, end) and `text`. Stages and progress notes are taken down on their way to the
/// progress that is shown; notes at most four times a second.
class RunLog : public Progress {
 public:
  /// \throws IoError if the file cannot be opened.
  RunLog(const std::filesystem::path& file, Progress& shown);
  void stage(const std::string& name) override;
  void update(double fraction, const std::string& note) override;
  void check_cancelled() const override { shown_->check_cancelled(); }
  void warning(const std::string& text) { write("warning", text); }
  /// Last line; \throws IoError if anything could not be written.
  void end(const std::string& text);

 private:
  using Clock = std::chrono::steady_clock;
  void write(const std::string& event, const std::string& text);

  std::filesystem::path file_;
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> stream_;
  Progress* shown_;
  Clock::time_point start_ = Clock::now(), last_note_ = start_ - std::chrono::seconds(1);
};

}  // namespace loosefit::io

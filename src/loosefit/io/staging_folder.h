#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "loosefit/io/plain_files.h"

namespace loosefit {

/// The hidden folder `.NAME.writing-PID` in which an output called NAME is made. It lies beside the
/// output, or in it where nothing can be moved between the two (a mount point, no permission).
/// It bears the file `.loosefit-writing` with the process, which keeps it locked.
class StagingFolder {
 public:
  /// \param target the output, without links; need not be there. \throws IoError
  explicit StagingFolder(const std::filesystem::path& target);
  StagingFolder(StagingFolder&&) noexcept = default;
  /// Removes it, unless kept.
  ~StagingFolder();

  const std::filesystem::path& path() const { return path_; }
  /// Relative to the output: "../.out.writing-7" or ".out.writing-7".
  std::string from_target() const;
  /// Where new files are made, and where old ones wait for the end of a commit.
  std::filesystem::path incoming() const { return path_ / "new"; }
  std::filesystem::path outgoing() const { return path_ / "old"; }
  /// Leaves it for the next process.
  void keep() { path_.clear(); }

 private:
  bool inside_ = false;
  std::filesystem::path path_;
  std::optional<FileLock> lock_;
};

/// Whether the process that made a hidden folder is gone: its lock is free, and its number is that
/// of no process or of one that was started later.
bool is_abandoned(const std::filesystem::path& staging);

/// Removes what StagingFolder makes, and nothing else that may lie in it.
void remove_staging(const std::filesystem::path& staging);

/// Removes hidden folders for `target` whose process is gone. One with files that a commit has
/// taken out of an output and not given back stays.
void clear_left_overs(const std::filesystem::path& target);

/// Whether a folder holds nothing, hidden folders of ours aside. \throws IoError
bool is_empty_output(const std::filesystem::path& target);

}  // namespace loosefit

#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "loosefit/io/plain_files.h"

namespace loosefit::io {

/// The hidden folder `.NAME.writing-PID` in which an output called NAME is made. It lies beside the
/// output, or in it where nothing can be moved between the two (a mount point, no permission).
/// It bears the file `.loosefit-writing` with the process, which keeps it locked.
class StagingFolder {
 public:
  /// \param target the output, without links; need not be there. \throws IoError
  explicit StagingFolder(const std::filesystem::path& target);
  StagingFolder(StagingFolder&&) noexcept = default;
  /// Removes it, unless kept, or needed to bring an output back to what it was.
  ~StagingFolder();

  const std::filesystem::path& path() const { return path_; }
  /// Relative to the output: "../.out.writing-7" or ".out.writing-7".
  std::string from_target() const;
  /// Where new files are made, and where old ones wait for the end of a commit.
  std::filesystem::path incoming() const { return path_ / "new"; }
  std::filesystem::path outgoing() const { return path_ / "old"; }
  /// Whether the mark of the output says that a commit from this folder is not finished.
  /// \throws IoError if the mark cannot be read.
  bool commit_is_open() const;
  /// Leaves it for the next process.
  void keep() { path_.clear(); }
  /// Leaves it for good: without the file of its process it is foreign to every later one.
  void give_away();

 private:
  void remove_unless_needed() const;

  bool inside_ = false;
  std::filesystem::path target_, path_;
  std::optional<FileLock> lock_;
};

/// Whether the process that made a hidden folder is gone: its lock is free, and its number is that
/// of no process or of one that was started later.
bool is_abandoned(const std::filesystem::path& staging);

/// Whether files lie in it that a commit has taken out of an output and not given back.
bool holds_taken_files(const std::filesystem::path& staging);

/// Removes what StagingFolder makes, and nothing else that may lie in it.
void remove_staging(const std::filesystem::path& staging);

/// Removes hidden folders for `target` whose process is gone. One with files that a commit has
/// taken out of an output and not given back stays.
void clear_left_overs(const std::filesystem::path& target);

/// Whether a folder holds nothing, hidden folders of ours aside. \throws IoError
bool is_empty_output(const std::filesystem::path& target);

}  // namespace loosefit::io

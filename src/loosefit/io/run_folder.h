#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "loosefit/base/error.h"
#include "loosefit/io/output_mark.h"
#include "loosefit/io/staging_folder.h"

namespace loosefit::io {

/// Files of one command that appear in their folder all at once or not at all, and that never take
/// the place of anything but files that we wrote and that nobody has changed since.
///
/// They are made in a hidden folder (io/staging_folder.h), which takes the name asked for in
/// commit() when nothing has it, and otherwise gives its files to the folder that is there
/// (io/replace_files.h). An output bears a mark (io/output_mark.h) with the SHA-256 of every file
/// of ours; what is not in it, or not as the mark says, is foreign and stays as it is. A link to a
/// folder is written through; links in a folder are foreign.
///
/// Every way to start first repairs what a killed process has left of the same output.
class RunFolder {
 public:
  /// A whole output of a kind ("run", "validation"), in a new or empty folder, or in the place of
  /// an earlier one of that kind: its files go, foreign ones stay.
  /// \throws InvalidInput if something else is there; IoError if the hidden folder cannot be made.
  static RunFolder create(const std::filesystem::path& folder, const std::string& kind = "run");
  /// Changes or adds files of an earlier run; those that are not written again stay. In a run
  /// without a mark (of Loosefit 0.1) what is in the way is set aside.
  /// \throws InvalidInput if it is not an earlier output; IoError.
  static RunFolder update(const std::filesystem::path& existing, const std::string& kind = "run");
  /// Adds files to any folder but the output of a run, whose files belong together, or makes it.
  /// \throws InvalidInput, IoError.
  static RunFolder add(const std::filesystem::path& folder, const std::string& kind);

  RunFolder(RunFolder&&) noexcept = default;
  ~RunFolder();

  /// Where to write now.
  std::filesystem::path path() const { return staging_->incoming(); }
  /// Says early what will be written, before long work. \throws InvalidInput naming those in whose
  /// place something foreign or changed stands.
  void announce(const std::vector<std::string>& planned) const;
  /// This file stays as it is when somebody has edited it.
  void leave_if_edited(const std::string& file) { leave_edited_.insert(file); }
  /// Puts the files in their place. \throws InvalidInput if something foreign has come in the way,
  /// MadeMeanwhile if another output has, IoError; everything is then as before, and a whole output
  /// goes to a free name beside the folder when only the former.
  void commit();
  /// The folder to which commit() has set files aside, relative to the output; mostly none.
  const std::string& aside() const { return aside_; }

 private:
  enum class Mode { whole, update, add };
  RunFolder(std::filesystem::path target, std::string kind, Mode mode);
  void check_target() const;
  bool has_mark_of_run() const;
  bool sets_aside() const;
  void become_target(const std::filesystem::path& target);
  [[noreturn]] void save_elsewhere(const InvalidInput& why);

  std::filesystem::path target_;  ///< without links
  std::string kind_, aside_;
  Mode mode_;
  std::set<std::string> leave_edited_;
  std::optional<std::map<std::string, std::string>> found_;  ///< OutputMark::made at the start
  std::vector<std::filesystem::path> parents_;  ///< that were made for it, the outer ones first
  std::optional<StagingFolder> staging_;
};

/// Repairs an output that a killed process has left half replaced; to be called before reading one.
/// \throws IoError if that cannot be done.
void repair_output(const std::filesystem::path& folder);

}  // namespace loosefit::io

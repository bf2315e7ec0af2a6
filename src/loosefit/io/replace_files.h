#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "loosefit/base/error.h"
#include "loosefit/io/output_mark.h"

namespace loosefit::io {

// How the files of an output take the place of those of an earlier one, in a folder that may hold
// other things too. Nothing is ever copied over or followed through a link; files only move, within
// one file system:
//
//   1. everything is on the disk in the hidden folder: new files, the mark of afterwards
//   2. the mark in the output is replaced by one that also lists what goes and what comes (pending)
//   3. old files move from the output to the hidden folder, then new ones the other way
//   4. old files are read once more, as somebody may have saved one after it was looked at; then
//      the mark of afterwards replaces the pending one: this is the commit
//   5. the hidden folder is removed
//
// When a step fails, what moved moves back. When the process is killed between 2 and 4, the pending
// mark tells the next one which file is which, and it moves them back (roll_back). Foreign files
// are in neither list.

/// What is wanted of a folder that exists.
struct Replacement {
  std::filesystem::path target;    ///< without links
  std::filesystem::path incoming;  ///< new files, below the hidden folder
  std::string kind;                ///< the set of files that this is
  bool whole = false;  ///< files of an earlier set of this kind that do not come again go
  /// Files that stay as they are when they are not as we wrote them.
  std::set<std::string> leave_edited;
  /// Files in the way of which the mark knows nothing move to `replaced-1`, … of the folder instead
  /// of being an error: for outputs of versions that wrote no mark.
  bool set_aside = false;
  /// Names of the whole outputs (OutputMark::made) that were there when the work began: new files
  /// of a part belong to them, a whole new one takes their place. Nothing: whatever is there is as
  /// good.
  std::optional<std::map<std::string, std::string>> found_there = {};
};

/// Files stand where new ones should go, and are not ours, or not as we wrote them.
class FilesInTheWay : public InvalidInput {
 public:
  FilesInTheWay(const std::filesystem::path& folder, const std::vector<std::string>& names);
};

/// Another whole output has come while this one was made.
class MadeMeanwhile : public InvalidInput {
 public:
  using InvalidInput::InvalidInput;
  explicit MadeMeanwhile(const std::filesystem::path& folder);
};

/// Those of `planned` where something stands that is not ours, or not as we wrote it.
std::vector<std::string> in_the_way(const std::filesystem::path& folder, const OutputMark& mark,
                                    const std::vector<std::string>& planned);

/// Carries out steps 1 to 4. `staging` is the hidden folder relative to the target. Returns the
/// folder to which files were set aside, if any.
/// \throws FilesInTheWay with nothing changed, or moved back when files were changed meanwhile;
/// MadeMeanwhile with nothing changed when other whole outputs are there than `found_there`;
/// IoError, or whatever else has gone wrong, with everything moved back.
std::string replace_files(const Replacement& wish, const std::string& staging);

/// Brings a folder whose commit was killed back to what it was before; nothing to do for any other.
/// \throws IoError if it cannot, or another process is just writing it; InvalidInput as
/// read_output_mark.
void roll_back(const std::filesystem::path& target);

}  // namespace loosefit::io

#pragma once
#include <filesystem>
#include <string>

namespace loosefit {

/// An output folder that is either there in full or not at all: files are written into a hidden
/// sibling, which takes the wanted name in commit() and is removed otherwise (error, Ctrl-C).
class RunFolder {
 public:
  /// Starts an empty folder for `wanted`. An existing folder is only ever replaced when it is empty
  /// or an earlier output of the same kind (it holds the file `mark`).
  /// \throws InvalidInput if something else is there; IoError if the sibling cannot be made.
  static RunFolder create(const std::filesystem::path& wanted,
                          const std::string& mark = "summary.json");
  /// Starts with a copy of the earlier output `existing`, to change or add files of it.
  /// \throws InvalidInput if it is not an earlier output; IoError.
  static RunFolder update(const std::filesystem::path& existing);

  RunFolder(RunFolder&& other) noexcept;
  RunFolder& operator=(RunFolder&&) = delete;
  ~RunFolder();

  /// Where to write now.
  const std::filesystem::path& path() const { return temporary_; }
  /// Puts the folder in its place. \throws IoError; the old folder is then as before.
  void commit();

 private:
  explicit RunFolder(const std::filesystem::path& wanted);

  std::filesystem::path wanted_, temporary_;
};

/// Makes a plain folder for single files. \throws InvalidInput if it is the output of a run, whose
/// files belong together; IoError if it cannot be made.
void make_plain_folder(const std::filesystem::path& folder);

}  // namespace loosefit

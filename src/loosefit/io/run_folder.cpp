#include "loosefit/io/run_folder.h"

#include <unistd.h>

#include <string>

#include "loosefit/base/error.h"

namespace loosefit {
namespace fs = std::filesystem;
namespace {

fs::path without_trailing_slash(const fs::path& path) {
  return path.has_filename() ? path : path.parent_path();
}

fs::path sibling(const fs::path& wanted, const std::string& purpose) {
  return wanted.parent_path() /
         ("." + wanted.filename().string() + "." + purpose + "-" + std::to_string(getpid()));
}

bool is_earlier_output(const fs::path& path, const std::string& mark = "summary.json") {
  std::error_code error;
  return fs::is_directory(path, error) && fs::is_regular_file(path / mark, error);
}

}  // namespace

RunFolder::RunFolder(const fs::path& wanted)
    : wanted_(without_trailing_slash(fs::absolute(wanted).lexically_normal())),
      temporary_(sibling(wanted_, "writing")) {
  std::error_code error;
  fs::create_directories(wanted_.parent_path(), error);
  if (!error) fs::remove_all(temporary_, error);
  if (!error) fs::create_directory(temporary_, error);
  if (error)
    throw IoError(wanted_.string() + ": cannot be written: " + error.message(),
                  "choose another folder with -o");
}

RunFolder RunFolder::create(const fs::path& wanted, const std::string& mark) {
  if (wanted.empty()) throw InvalidInput({"", 0, "-o"}, "an empty name", "the folder to write");
  std::error_code error;
  const bool there = fs::exists(fs::symlink_status(wanted, error));
  const bool replaceable = is_earlier_output(wanted, mark) ||
                           (fs::is_directory(wanted, error) && fs::is_empty(wanted, error));
  if (there && !replaceable)
    throw InvalidInput({wanted.string(), 0, ""}, "something that is not an earlier output",
                       "a new folder, or one that holds " + mark,
                       "nothing was changed; choose another folder with -o");
  return RunFolder(wanted);
}

RunFolder RunFolder::update(const fs::path& existing) {
  if (!is_earlier_output(existing))
    throw InvalidInput({existing.string(), 0, ""}, "no earlier output",
                       "a folder written by loosefit run or loosefit drape");
  RunFolder folder(existing);
  std::error_code error;
  fs::copy(existing, folder.temporary_, fs::copy_options::recursive, error);
  if (error) throw IoError(folder.temporary_.string() + ": cannot be written: " + error.message());
  return folder;
}

RunFolder::RunFolder(RunFolder&& other) noexcept
    : wanted_(std::move(other.wanted_)), temporary_(std::move(other.temporary_)) {
  other.temporary_.clear();
}

RunFolder::~RunFolder() {
  std::error_code ignored;
  if (!temporary_.empty()) fs::remove_all(temporary_, ignored);
}

void RunFolder::commit() {
  const fs::path old = sibling(wanted_, "replaced");
  std::error_code error;
  const bool replaces = fs::exists(wanted_, error);
  if (replaces) fs::rename(wanted_, old, error);
  if (!error) {
    fs::rename(temporary_, wanted_, error);
    if (error && replaces) {
      std::error_code ignored;
      fs::rename(old, wanted_, ignored);
    }
  }
  if (error) throw IoError(wanted_.string() + ": cannot be written: " + error.message());
  temporary_.clear();
  std::error_code ignored;
  if (replaces) fs::remove_all(old, ignored);
}

void make_plain_folder(const fs::path& folder) {
  if (is_earlier_output(folder))
    throw InvalidInput({folder.string(), 0, ""}, "the output of a run (it holds summary.json)",
                       "another folder", "nothing was changed; choose another folder with -o");
  std::error_code error;
  fs::create_directories(folder, error);
  if (error)
    throw IoError(folder.string() + ": cannot make the folder: " + error.message(),
                  "choose another folder with -o");
}

}  // namespace loosefit

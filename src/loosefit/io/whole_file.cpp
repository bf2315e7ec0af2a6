#include "loosefit/io/whole_file.h"

#include <unistd.h>

#include "loosefit/base/error.h"
#include "loosefit/io/output_name.h"
#include "loosefit/io/plain_files.h"
#include "loosefit/io/text_file.h"

namespace loosefit::io {
namespace {

/// A file that is gone with its owner.
struct TemporaryFile {
  std::filesystem::path path;
  ~TemporaryFile() {
    std::error_code error;
    std::filesystem::remove(path, error);
  }
};

}  // namespace

void check_whole_file(const std::filesystem::path& file, bool may_replace) {
  check_output_name(file);
  const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
  std::error_code error;
  if (!std::filesystem::is_directory(folder, error))
    throw IoError(file.string() + ": found no folder " + folder.string() +
                  ", expected one that is there");
  if (std::filesystem::is_directory(file, error))
    throw InvalidInput({file.string(), 0, ""}, "a folder", "the name of a file");
  if (std::filesystem::exists(file, error) && !std::filesystem::is_regular_file(file, error))
    throw InvalidInput({file.string(), 0, ""}, "a device or a pipe", "the name of a file");
  if (!may_replace && is_there(file))
    throw InvalidInput({file.string(), 0, ""}, "a file that is there already",
                       "a free name, or --overwrite");
}

void write_whole_file(const std::filesystem::path& file, const std::string& bytes,
                      bool may_replace) {
  check_whole_file(file, may_replace);
  const TemporaryFile part{file.parent_path() / ("." + file.filename().string() + "." +
                                                 std::to_string(getpid()) + ".part")};
  write_text_file(part.path.string(), bytes);
  sync_to_disk(part.path);
  if (may_replace)
    move_over(part.path, file);
  else
    move_to_free_name(part.path, file);
}

}  // namespace loosefit::io

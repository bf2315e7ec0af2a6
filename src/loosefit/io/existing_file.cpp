#include "loosefit/io/existing_file.h"

#include <filesystem>

namespace loosefit::io {

std::string existing_file(ConfigReader& table, const std::string& key, const std::string& about,
                          const std::string& pattern) {
  namespace fs = std::filesystem;
  const fs::path named = table.path(key, pattern, about);
  if (table.recording()) return named.string();
  std::error_code error;
  const fs::path full = fs::weakly_canonical(
      named.is_absolute() ? named : fs::path(table.file_of(key)).parent_path() / named, error);
  if (error || !fs::is_regular_file(full, error))
    throw table.error(key, "a file that exists",
                      "paths are relative to the folder of the file that names them");
  return full.string();
}

}  // namespace loosefit::io

#include "loosefit/base/paths.h"

#include <cstdlib>

namespace loosefit {

namespace fs = std::filesystem;

std::filesystem::path data_directory() {
  if (const char* given = std::getenv("LOOSEFIT_SHARE"); given && *given) return given;
  std::error_code error;
  const fs::path binary = fs::read_symlink("/proc/self/exe", error);
  if (!error) {
    const fs::path installed = binary.parent_path().parent_path() / "share" / "loosefit";
    if (fs::is_directory(installed, error)) return installed;
  }
  return fs::path(LOOSEFIT_SOURCE_DIR) / "data";
}

std::string default_body_data_path() {
  const char* asked = std::getenv("LOOSEFIT_DATA");
  if (asked && *asked) {
    const std::filesystem::path path(asked);
    std::error_code ignored;
    return std::filesystem::is_directory(path, ignored) ? (path / "body.lfb").string()
                                                        : path.string();
  }
  return LOOSEFIT_SOURCE_DIR "/var/body/body.lfb";
}

}  // namespace loosefit

#include "loosefit/base/paths.h"

#include <cstdlib>

namespace loosefit {

std::filesystem::path data_directory() {
  namespace fs = std::filesystem;
  if (const char* chosen = std::getenv("LOOSEFIT_SHARE"); chosen && *chosen) return chosen;
  std::error_code error;
  const fs::path binary = fs::read_symlink("/proc/self/exe", error);
  if (!error) {
    const fs::path installed = binary.parent_path().parent_path() / "share" / "loosefit";
    if (fs::is_directory(installed, error)) return installed;
  }
  return fs::path(LOOSEFIT_SOURCE_DIR) / "data";
}

}  // namespace loosefit

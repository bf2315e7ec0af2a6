#include <cstdlib>
#include <filesystem>

#include "loosefit/body/body_data.h"

namespace loosefit {

std::string default_body_data_path() {
  const char* asked = std::getenv("LOOSEFIT_DATA");
  if (asked && *asked) {
    const std::filesystem::path path(asked);
    std::error_code ignored;
    return std::filesystem::is_directory(path, ignored) ? (path / "body.lfb").string()
                                                        : path.string();
  }
  return LOOSEFIT_REPOSITORY "/var/body/body.lfb";
}

}  // namespace loosefit

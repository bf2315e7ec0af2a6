#include "loosefit/base/paths.h"

#include <cstdlib>
#include <mutex>
#include <utility>

namespace loosefit {

namespace fs = std::filesystem;

namespace {

/// What the process was told.
struct Told {
  std::mutex mutex;
  fs::path data, installation;
};

Told& told() {
  static Told all;
  return all;
}

/// Empty: not set.
fs::path environment(const char* name) {
  const char* value = std::getenv(name);
  return value ? fs::path(value) : fs::path();
}

/// Named by the caller or by the user, so that nothing else may be taken in its stead.
bool is_named(const fs::path& folder) {
  const std::lock_guard lock(told().mutex);
  return folder == told().data || folder == environment("LOOSEFIT_DATA");
}

bool has_other_data(const fs::path& folder) {
  std::error_code ignored;
  return fs::is_directory(folder / "materials", ignored) ||
         fs::is_directory(folder / "scorecards", ignored);
}

}  // namespace

fs::path user_data_folder() {
  if (const fs::path data = environment("XDG_DATA_HOME"); data.is_absolute())
    return data / "loosefit";
  const fs::path home = environment("HOME");
  return home.is_absolute() ? home / ".local" / "share" / "loosefit" : fs::path();
}

void use_data_folder(const fs::path& folder) {
  const std::lock_guard lock(told().mutex);
  told().data = folder;
}

void use_installation(const fs::path& folder) {
  const std::lock_guard lock(told().mutex);
  told().installation = folder;
}

std::vector<fs::path> data_folders() {
  std::vector<fs::path> folders;
  const auto look = [&](const fs::path& folder) {
    if (!folder.empty()) folders.push_back(folder);
  };
  const std::lock_guard lock(told().mutex);
  const fs::path shared = fs::path("share") / "loosefit";
  look(told().data);
  look(environment("LOOSEFIT_DATA"));
  look(user_data_folder());
  look(told().installation.empty() ? fs::path() : told().installation / shared);
  look(fs::path(LOOSEFIT_INSTALL_PREFIX) / shared);
  look(kSystemDataFolder);
  look(fs::path(LOOSEFIT_SOURCE_DIR) / "var" / "body");
  look(fs::path(LOOSEFIT_SOURCE_DIR) / "data");
  return folders;
}

fs::path data_directory() {
  if (const fs::path given = environment("LOOSEFIT_SHARE"); !given.empty()) return given;
  const std::vector<fs::path> folders = data_folders();
  std::error_code ignored;
  for (const fs::path& folder : folders)
    if (fs::is_directory(folder / "materials", ignored)) return folder;
  return folders.back();
}

std::string default_body_data_path() {
  const std::vector<fs::path> folders = data_folders();
  std::error_code ignored;
  for (const fs::path& folder : folders) {
    if (folder.extension() == ".lfb" || fs::is_regular_file(folder, ignored))
      return folder.string();
    if (fs::exists(folder / "body.lfb", ignored)) return (folder / "body.lfb").string();
    if (is_named(folder) && !has_other_data(folder)) return (folder / "body.lfb").string();
  }
  return (folders.front() / "body.lfb").string();
}

std::string looked_in() {
  std::string text = "looked in";
  const char* between = " ";
  for (const fs::path& folder : data_folders()) text += std::exchange(between, ", ") + folder.string();
  return text;
}

}  // namespace loosefit

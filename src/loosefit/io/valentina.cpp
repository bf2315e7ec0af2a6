#include "loosefit/io/valentina.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <thread>
#include <vector>

#include "loosefit/base/error.h"
#include "loosefit/base/text.h"
#include "loosefit/io/dxf/dxf_read.h"

namespace loosefit::io {
namespace {

namespace fs = std::filesystem;

constexpr std::chrono::seconds kLongest{120};  // that an export may take
constexpr const char* kProgram = "valentina";

/// A folder that is gone afterwards.
class Folder {
 public:
  Folder() {
    std::string name = (fs::temp_directory_path() / "loosefit-valentina-XXXXXX").string();
    if (!mkdtemp(name.data()))
      throw IoError("no folder can be made in " + fs::temp_directory_path().string() + ": " +
                    std::strerror(errno));
    path_ = name;
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

bool installed() {
  const char* path = std::getenv("PATH");
  const std::string all = path ? path : "";
  for (std::size_t at = 0; at <= all.size();) {
    const std::size_t end = std::min(all.find(':', at), all.size());
    const std::string folder = all.substr(at, end - at);
    if (!folder.empty() && access((folder + "/" + kProgram).c_str(), X_OK) == 0) return true;
    at = end + 1;
  }
  return false;
}

/// Runs Valentina without a window, what it says into `log`. Its settings and lock files stay in
/// `home`. \return its exit code; −1 when it took too long or was killed
int run(const std::vector<std::string>& arguments, const fs::path& home, const fs::path& log) {
  std::vector<std::string> environment = {"QT_QPA_PLATFORM=offscreen", "HOME=" + home.string(),
                                          "XDG_CONFIG_HOME=" + home.string(),
                                          "XDG_RUNTIME_DIR=" + home.string(), "LC_ALL=C.UTF-8"};
  if (const char* path = std::getenv("PATH")) environment.push_back(std::string("PATH=") + path);
  std::vector<char*> argv, envp;
  for (const std::string& a : arguments) argv.push_back(const_cast<char*>(a.c_str()));
  for (const std::string& e : environment) envp.push_back(const_cast<char*>(e.c_str()));
  argv.push_back(nullptr);
  envp.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, 1, log.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0600);
  posix_spawn_file_actions_adddup2(&actions, 1, 2);
  pid_t child = 0;
  const int failed = posix_spawnp(&child, kProgram, &actions, nullptr, argv.data(), envp.data());
  posix_spawn_file_actions_destroy(&actions);
  if (failed != 0)
    throw IoError(std::string(kProgram) + " cannot be started: " + std::strerror(failed));
  const auto end = std::chrono::steady_clock::now() + kLongest;
  int status = 0;
  while (waitpid(child, &status, WNOHANG) == 0) {
    if (std::chrono::steady_clock::now() > end) {
      kill(child, SIGKILL);
      waitpid(child, &status, 0);
      return -1;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

/// The last line in which it complains.
std::string complaint(const fs::path& log) {
  std::ifstream file(log);
  std::string last;
  for (std::string line; std::getline(file, line);)
    for (const char* word : {"ERROR", "CRITICAL", "FATAL", "WARNING"})
      if (line.find(word) != std::string::npos) last = line;
  return last;
}

}  // namespace

PatternFile read_valentina(const fs::path& path, const PatternWish& wish) {
  if (!installed())
    throw InvalidInput(
        {path.string(), 0, {}}, kValentinaKind,
        "the program Valentina, which alone evaluates its formulas",
        "install the Debian package `valentina`, or export the pieces as DXF-AAMA or "
        "SVG there (File > Export layout or details)");
  const Folder folder;
  const fs::path log = folder.path() / "log.txt";
  const int code = run({kProgram, "-b", "pieces", "-d", folder.path().string(), "-f", "16",
                        "--exportOnlyDetails", fs::absolute(path).string()},
                       folder.path(), log);
  std::vector<fs::path> made;
  for (const auto& entry : fs::directory_iterator(folder.path()))
    if (entry.path().extension() == ".dxf") made.push_back(entry.path());
  if (made.empty()) {
    const std::string said = complaint(log);
    throw InvalidInput({path.string(), 0, {}},
                       code < 0 ? fmt::format("nothing from Valentina in {} s", kLongest.count())
                                : fmt::format("no pieces from Valentina, exit code {}{}", code,
                                              said.empty() ? "" : ": " + printable(said, 200)),
                       "a pattern with details whose measures it finds",
                       "open it there; the measurement file that it names must lie beside it");
  }
  std::sort(made.begin(), made.end());
  // It writes millimetres, which its file does not say.
  PatternWish millimetres = wish;
  if (millimetres.units.empty()) millimetres.units = "mm";
  PatternFile result = read_dxf_pattern(made.front(), millimetres);
  result.about.front() = "Valentina or Seamly2D, exported by Valentina as " + result.about.front();
  result.pattern.name = path.stem().string();
  return result;
}

}  // namespace loosefit::io

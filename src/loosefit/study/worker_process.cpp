#include "loosefit/study/worker_process.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

#include "loosefit/base/error.h"

namespace loosefit::study {
namespace {

constexpr off_t kTail = 4000;  ///< of what a program has said [bytes]

}  // namespace

WorkerProcess::WorkerProcess(const std::vector<std::string>& command) {
  std::vector<char*> arguments;
  for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  // A file in memory takes in whatever is said, without a reader that must keep up.
  output_ = memfd_create("loosefit-worker", MFD_CLOEXEC);
  const pid_t parent = getpid();
  // Not fork(), which has libraries wait for their threads first; one of a BLAS may have no memory.
  pid_ = output_ < 0 ? -1 : _Fork();
  if (pid_ < 0) {
    const std::string cause = std::strerror(errno);
    if (output_ >= 0) close(output_);
    throw IoError(command.front() + ": cannot be started: " + cause);
  }
  if (pid_ > 0) return;
  // In the child, until exec, only what is safe after a fork.
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(127);
  setpgid(0, 0);  // Ctrl-C is for the runner, which ends its workers
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  const int nothing = open("/dev/null", O_RDONLY);
  dup2(nothing, STDIN_FILENO);
  dup2(output_, STDOUT_FILENO);
  dup2(output_, STDERR_FILENO);
  execv(arguments.front(), arguments.data());
  _exit(127);
}

WorkerProcess::WorkerProcess(WorkerProcess&& other) noexcept
    : pid_(other.pid_), output_(other.output_) {
  other.pid_ = other.output_ = -1;
}

WorkerProcess::~WorkerProcess() {
  if (pid_ > 0) {
    kill(pid_, SIGKILL);
    waitpid(pid_, nullptr, 0);
  }
  if (output_ >= 0) close(output_);
}

std::optional<ProcessEnd> WorkerProcess::poll() {
  int status = 0;
  if (pid_ <= 0 || waitpid(pid_, &status, WNOHANG) != pid_) return {};
  pid_ = -1;
  ProcessEnd end;
  if (WIFSIGNALED(status))
    end.signal = WTERMSIG(status);
  else
    end.exit_code = WEXITSTATUS(status);
  end.output = said();
  return end;
}

std::string WorkerProcess::said() const {
  const off_t size = lseek(output_, 0, SEEK_END);
  if (size <= 0) return "";
  std::string text(static_cast<std::size_t>(std::min(size, kTail)), '\0');
  const ssize_t n =
      pread(output_, text.data(), text.size(), size - static_cast<off_t>(text.size()));
  text.resize(n > 0 ? static_cast<std::size_t>(n) : 0);
  while (!text.empty() && text.back() == '\n') text.pop_back();
  return text;
}

ProcessEnd run_to_end(const std::vector<std::string>& command) {
  WorkerProcess process(command);
  while (true) {
    if (const auto end = process.poll()) return *end;
    usleep(5000);
  }
}

std::string signal_name(int signal) {
  const char* words = sigdescr_np(signal);
  return "signal " + std::to_string(signal) + (words ? " (" + std::string(words) + ")" : "");
}

std::string own_program() {
  std::error_code error;
  const std::filesystem::path path = std::filesystem::read_symlink("/proc/self/exe", error);
  if (error) throw IoError("/proc/self/exe: cannot be read: " + error.message());
  return path.string();
}

}  // namespace loosefit::study

#include "loosefit/render/x_server.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/random.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cctype>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <thread>

#include "loosefit/base/error.h"

namespace loosefit::render {
namespace {

using Clock = std::chrono::steady_clock;

constexpr auto kPatience = std::chrono::seconds(10);  // it takes 0.2 s; a busy machine needs longer
constexpr auto kFarewell = std::chrono::seconds(2);
constexpr int kNumberPipe = 3, kAuthority = 4;  // what the server finds open

/// A file handle that closes itself.
struct Handle {
  int number = -1;
  explicit Handle(int n = -1) : number(n) {}
  ~Handle() { reset(); }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  void reset() {
    if (number >= 0) close(number);
    number = -1;
  }
};

/// Full path of a program; empty if PATH has none. Before the fork: after it, hardly anything may
/// be called in a process with several threads.
std::string find_program(const std::string& name) {
  const char* all = std::getenv("PATH");
  std::string rest = all ? all : "/usr/local/bin:/usr/bin:/bin";
  rest += ":";
  for (std::size_t end; (end = rest.find(':')) != std::string::npos; rest.erase(0, end + 1)) {
    const std::string path = (end == 0 ? "." : rest.substr(0, end)) + "/" + name;
    std::error_code error;
    if (std::filesystem::is_regular_file(path, error) && access(path.c_str(), X_OK) == 0)
      return path;
  }
  return {};
}

std::string random_bytes(std::size_t count) {
  std::string bytes(count, '\0');
  for (std::size_t have = 0; have < count;) {
    const ssize_t got = getrandom(bytes.data() + have, count - have, 0);
    if (got < 0 && errno != EINTR) throw Error("no random numbers from the system");
    if (got > 0) have += static_cast<std::size_t>(got);
  }
  return bytes;
}

void append_counted(std::string& text, const std::string& part) {
  text += static_cast<char>(part.size() >> 8);
  text += static_cast<char>(part.size() & 0xff);
  text += part;
}

/// An authority file (Xau library: family, address, number, name, data) with one cookie for every
/// address. In memory only: nothing of it can be left on a disk.
int authority_file(const std::string& cookie) {
  std::string entry = "\xff\xff";  // FamilyWild
  for (const std::string& part :
       {std::string(), std::string(), std::string("MIT-MAGIC-COOKIE-1"), cookie})
    append_counted(entry, part);
  const int file = memfd_create("loosefit-xauthority", MFD_CLOEXEC);
  if (file < 0 || write(file, entry.data(), entry.size()) != static_cast<ssize_t>(entry.size())) {
    if (file >= 0) close(file);
    throw Error("no memory for the key of a screen of our own");
  }
  return file;
}

/// In the child, where only calls that are safe in a signal handler may be made: becomes the server
/// or ends.
[[noreturn]] void become_server(const char* program, char* const* arguments, pid_t parent,
                                int number_pipe, int authority) {
  setsid();                             // Ctrl-C of the terminal is not for it
  prctl(PR_SET_PDEATHSIG, SIGTERM);     // with us it goes, and cleans up
  if (getppid() != parent) _exit(127);  // we were gone before that was said
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  for (int number : {SIGINT, SIGTERM, SIGHUP, SIGUSR1, SIGPIPE}) signal(number, SIG_DFL);
  // Out of the way first: either may have the number of the other.
  const int pipe_copy = fcntl(number_pipe, F_DUPFD, 10);
  const int authority_copy = fcntl(authority, F_DUPFD, 10);
  const int nothing = open("/dev/null", O_RDWR);
  if (pipe_copy < 0 || authority_copy < 0 || nothing < 0) _exit(127);
  for (int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) dup2(nothing, stream);
  dup2(pipe_copy, kNumberPipe);
  dup2(authority_copy, kAuthority);
  close_range(kAuthority + 1, ~0U, 0);
  execv(program, arguments);
  _exit(127);
}

/// What the server writes once it answers: its number. Empty when it ends or time is up.
std::string wait_for_number(int pipe) {
  const auto deadline = Clock::now() + kPatience;
  std::string number;
  for (;;) {
    const auto left =
        std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now());
    if (left.count() <= 0) return {};
    pollfd wait = {pipe, POLLIN, 0};
    const int ready = poll(&wait, 1, static_cast<int>(left.count()));
    if (ready < 0 && errno != EINTR) return {};
    if (ready <= 0) continue;
    char c = 0;
    const ssize_t got = read(pipe, &c, 1);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return {};
    if (c == '\n') return number;
    if (!std::isdigit(static_cast<unsigned char>(c))) return {};
    number += c;
  }
}

}  // namespace

XServer::XServer() {
  const std::string program = find_program("Xvfb");
  if (program.empty()) throw Error("there is no Xvfb on PATH", "install the package xvfb");
  cookie_ = random_bytes(16);
  const Handle authority(authority_file(cookie_));
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) throw Error("no pipe for a screen of our own");
  const Handle from(ends[0]);
  Handle to(ends[1]);
  // It must not reset itself when its last client leaves: the next one would be thrown out.
  const std::string handle = std::to_string(kNumberPipe);
  const std::string authority_path = "/proc/self/fd/" + std::to_string(kAuthority);
  const char* arguments[] = {"Xvfb",
                             "-displayfd",
                             handle.c_str(),
                             "-screen",
                             "0",
                             "1280x1024x24",
                             "-noreset",
                             "-nolisten",
                             "tcp",
                             "-auth",
                             authority_path.c_str(),
                             nullptr};
  const pid_t parent = getpid();
  // Not fork(), which has libraries wait for their threads first; one of a BLAS may have no memory.
  process_ = _Fork();
  if (process_ == 0)
    become_server(program.c_str(), const_cast<char* const*>(arguments), parent, to.number,
                  authority.number);
  if (process_ < 0)
    throw Error("no process for a screen of our own: " + std::string(std::strerror(errno)));
  to.reset();
  const std::string number = wait_for_number(from.number);
  if (number.empty()) {
    stop();
    throw Error("Xvfb (" + program + ") does not come up",
                "start it by hand to see why: Xvfb -displayfd 1");
  }
  name_ = ":" + number;
}

XServer::~XServer() { stop(); }

void XServer::stop() {
  if (process_ <= 0) return;
  kill(process_, SIGTERM);
  // It takes its socket and lock file along; one that does not end is ended.
  const auto deadline = Clock::now() + kFarewell;
  while (waitpid(process_, nullptr, WNOHANG) == 0) {
    if (Clock::now() > deadline) {
      kill(process_, SIGKILL);
      waitpid(process_, nullptr, 0);
      break;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  process_ = -1;
}

}  // namespace loosefit::render

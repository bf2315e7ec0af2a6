#pragma once
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <stdexcept>
#include <string>

namespace loosefit::testing {

/// An X server of our own while it lives, unless DISPLAY names one; tests of pictures need no more
/// than the package xvfb. Throws when Xvfb cannot be started.
class VirtualDisplay {
 public:
  VirtualDisplay() {
    const char* given = std::getenv("DISPLAY");
    if (given && *given) return;
    int channel[2];
    if (pipe(channel) != 0) throw std::runtime_error("no pipe");
    server_ = fork();
    if (server_ == 0) {
      close(channel[0]);
      const std::string number = std::to_string(channel[1]);
      execlp("Xvfb", "Xvfb", "-displayfd", number.c_str(), "-screen", "0", "1280x1024x24",
             "-nolisten", "tcp", "-noreset", static_cast<char*>(nullptr));
      _exit(127);
    }
    close(channel[1]);
    std::string number;
    for (char c; read(channel[0], &c, 1) == 1 && c != '\n';) number += c;
    close(channel[0]);
    if (number.empty()) throw std::runtime_error("Xvfb does not start; is the package xvfb there?");
    setenv("DISPLAY", (":" + number).c_str(), 1);
  }
  ~VirtualDisplay() {
    if (server_ <= 0) return;
    kill(server_, SIGTERM);
    waitpid(server_, nullptr, 0);
    unsetenv("DISPLAY");
  }
  VirtualDisplay(const VirtualDisplay&) = delete;
  VirtualDisplay& operator=(const VirtualDisplay&) = delete;

 private:
  pid_t server_ = -1;
};

}  // namespace loosefit::testing

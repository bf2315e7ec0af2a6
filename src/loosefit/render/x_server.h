#pragma once
#include <sys/types.h>

#include <string>

namespace loosefit::render {

/// An X server without a monitor (Xvfb) that belongs to this object: on a number that was free,
/// reachable on this machine only and with a cookie that nobody else has. It ends with the object,
/// with the thread that made it, and with the process however that ends (also by SIGKILL), and
/// takes its socket and lock file along. Ctrl-C of a terminal does not reach it, so that what draws
/// on it can end in good order.
class XServer {
 public:
  /// Waits until it answers, at most a few seconds. \throws Error when there is no Xvfb on PATH or
  /// it does not come up.
  XServer();
  ~XServer();
  XServer(const XServer&) = delete;
  XServer& operator=(const XServer&) = delete;

  /// ":7"
  const std::string& name() const { return name_; }
  /// Key that a client has to show, of the protocol MIT-MAGIC-COOKIE-1: 16 bytes.
  const std::string& cookie() const { return cookie_; }
  pid_t process() const { return process_; }

 private:
  void stop();

  std::string name_, cookie_;
  pid_t process_ = -1;
};

}  // namespace loosefit::render

#pragma once
#include <signal.h>
#include <unistd.h>

#include <cerrno>
#include <functional>
#include <string>

// What support/file_faults.h does to changes of the file system.
namespace loosefit::faults {

enum class Fault { none, kill, fail_once, fail_ever };

struct Plan {
  Fault fault = Fault::none;
  int at = 0;       ///< the first change has number 1
  int error = 0;    ///< errno of a failure
  int changes = 0;  ///< so far
  /// Called just before a change: the function of the C library, and what it changes (for a rename,
  /// the new name). It is not called for what it does itself. Returns errno when the change has to
  /// fail.
  std::function<int(const std::string& what, const std::string& path)> before;
};
inline Plan plan;

/// Asks plan.before; whether the change has to fail.
inline bool hook_refuses(const char* what, const char* path) {
  if (!plan.before) return false;
  const auto hook = plan.before;
  plan.before = nullptr;
  try {
    errno = hook(what, path);
  } catch (...) {
    plan.before = hook;
    throw;
  }
  const int error = errno;
  plan.before = hook;
  errno = error;
  return error != 0;
}

/// Whether the next change has to fail.
inline bool strikes(const char* what, const char* path) {
  if (hook_refuses(what, path)) return true;
  const int number = ++plan.changes;
  if (plan.fault == Fault::none || number < plan.at) return false;
  if (plan.fault == Fault::fail_once && number > plan.at) return false;
  if (plan.fault == Fault::kill) kill(getpid(), SIGKILL);
  errno = plan.error;
  return true;
}

}  // namespace loosefit::faults

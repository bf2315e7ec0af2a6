#pragma once
#include <sys/types.h>

#include <optional>
#include <string>
#include <vector>

namespace loosefit::study {

/// How a process ended.
struct ProcessEnd {
  int exit_code = 0;   ///< when it was not ended by a signal
  int signal = 0;      ///< that ended it; 0: none
  std::string output;  ///< the last it said on standard output and error
};

/// Another program that runs beside this one. It ends with this process, however that ends (Linux:
/// PR_SET_PDEATHSIG), and when the object goes.
class WorkerProcess {
 public:
  /// \throws IoError when it cannot be started.
  explicit WorkerProcess(const std::vector<std::string>& command);
  ~WorkerProcess();
  WorkerProcess(WorkerProcess&& other) noexcept;
  WorkerProcess& operator=(WorkerProcess&&) = delete;

  /// How it ended, if it has; to be asked until it has.
  std::optional<ProcessEnd> poll();
  pid_t id() const { return pid_; }

 private:
  std::string said() const;

  pid_t pid_ = -1;
  int output_ = -1;
};

/// Runs a program to its end and returns what it wrote on standard output, and how it ended.
ProcessEnd run_to_end(const std::vector<std::string>& command);

/// "signal 11 (Segmentation fault)"
std::string signal_name(int signal);

/// Path of the running program.
std::string own_program();

}  // namespace loosefit::study

#pragma once
#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <string>

namespace loosefit {

/// What a program did: exit code (128 + signal when it was killed) and everything it printed.
struct ProgramRun {
  int exit_code = -1;
  std::string output;  ///< standard output and error together
};

/// Runs a shell command with a time limit; a run that exceeds it ends with exit code 124.
inline ProgramRun run_program(const std::string& command, int limit_seconds = 300) {
  ProgramRun run;
  const std::string limited = "timeout -k 5 " + std::to_string(limit_seconds) + " " + command;
  std::FILE* pipe = popen(("( " + limited + " ) 2>&1 </dev/null").c_str(), "r");
  if (!pipe) return run;
  std::array<char, 4096> block;
  while (const std::size_t n = std::fread(block.data(), 1, block.size(), pipe))
    run.output.append(block.data(), n);
  const int status = pclose(pipe);
  run.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return run;
}

}  // namespace loosefit

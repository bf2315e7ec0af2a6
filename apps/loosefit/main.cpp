#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <new>

#include "command_body.h"
#include "command_doctor.h"
#include "command_material.h"
#include "command_pattern.h"
#include "command_rank.h"
#include "command_run.h"
#include "command_setup.h"
#include "command_stages.h"
#include "command_validate.h"
#include "exit_code.h"
#include "loosefit/base/error.h"
#include "loosefit/base/paths.h"
#include "loosefit/base/text.h"
#include "loosefit/base/version.h"
#include "usage_error.h"

namespace loosefit {
namespace {

/// A standard stream that is closed leaves its number to the next file that is opened, which would
/// then be written as if it were the stream. Something that cannot be written holds the place.
void hold_standard_streams() {
  for (int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (fcntl(stream, F_GETFD) == -1 && errno == EBADF && open("/dev/null", O_RDONLY) != stream)
      return;  // nothing to be done; the lowest free number is `stream`
}

/// The data lie beside the program, wherever it was installed.
void tell_installation() {
  std::error_code error;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
  if (!error) use_installation(program.parent_path().parent_path());
}

int failed(int code, const std::string& message, const std::string& hint = {}) {
  std::string text = "error: " + terminal_line(message) + "\n";
  if (!hint.empty()) text += "hint: " + terminal_line(hint) + "\n";
  std::fputs(text.c_str(), stderr);  // fmt would throw when nobody can read it
  return code;
}

int run_command_line(int count, char** arguments) {
  int exit_code = kGood;
  CLI::App app{
      "Loosefit drapes a garment on a body and maps how well sensors in it would measure."};
  app.name("loosefit");
  app.require_subcommand(1);
  app.set_version_flag("--version", version());
  add_run_commands(app, exit_code);
  add_body_command(app);
  add_pattern_command(app);
  add_stage_commands(app, exit_code);
  add_rank_command(app, exit_code);
  add_material_command(app);
  add_validate_command(app, exit_code);
  add_setup_command(app, exit_code);
  add_doctor_command(app, exit_code);
  app.add_subcommand("version", "version of this program and of its libraries")->callback([] {
    for (const auto& [library, number] : versions()) fmt::print("{:10} {}\n", library, number);
  });
  try {
    app.parse(count, arguments);
  } catch (const CLI::ParseError& e) {
    if (e.get_exit_code() == 0) return app.exit(e);  // --help, --version
    const UsageError error = explain_usage(app, {arguments + 1, arguments + count}, e);
    return failed(kBadInput, error.message, error.hint);
  }
  return exit_code;
}

/// The end of every command: what it printed has arrived, or it has failed.
int with_output_written(int exit_code) {
  errno = 0;
  if (std::fflush(stdout) == 0 && !std::ferror(stdout)) return exit_code;
  const std::string cause = errno != 0 ? std::string(": ") + std::strerror(errno) : "";
  failed(kBadInput, "standard output: cannot be written" + cause);
  return exit_code == kGood ? kBadInput : exit_code;
}

int run_guarded(int count, char** arguments) {
  try {
    return run_command_line(count, arguments);
  } catch (const Cancelled&) {
    return failed(kInterrupted, "interrupted; nothing was written");
  } catch (const SolverFailure& e) {
    return failed(kNotSettled, e.what(), e.hint());
  } catch (const Error& e) {
    return failed(kBadInput, e.what(), e.hint());
  } catch (const std::bad_alloc&) {
    return failed(kBadInput, "not enough memory", "a larger simulation.edge_length needs less");
  } catch (const std::exception& e) {
    if (std::ferror(stdout)) return kBadInput;  // fmt throws then; with_output_written tells
    return failed(kNotSettled, std::string("unexpected: ") + e.what(),
                  "this is a fault of Loosefit; please report it with the scenario");
  }
}

}  // namespace
}  // namespace loosefit

int main(int count, char** arguments) {
  using namespace loosefit;
  hold_standard_streams();
  tell_installation();
  return with_output_written(run_guarded(count, arguments));
}

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>
#include <filesystem>
#include <new>
#include <system_error>

#include "blank_values.h"
#include "command_body.h"
#include "command_doctor.h"
#include "command_material.h"
#include "command_pattern.h"
#include "command_rank.h"
#include "command_render.h"
#include "command_run.h"
#include "command_schema.h"
#include "command_setup.h"
#include "command_stages.h"
#include "command_study.h"
#include "command_validate.h"
#include "exit_code.h"
#include "interrupted.h"
#include "loosefit/base/disk_cache.h"
#include "loosefit/base/error.h"
#include "loosefit/base/paths.h"
#include "loosefit/base/resources.h"
#include "loosefit/base/text.h"
#include "loosefit/base/version.h"
#include "loosefit/report/error_document.h"
#include "loosefit/report/fact_documents.h"
#include "print_document.h"
#include "standard_error.h"
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

/// A file that may not grow any more is an error as a full disk is, not the end of the process.
void meet_limits_as_errors() { std::signal(SIGXFSZ, SIG_IGN); }

/// The data lie beside the program, wherever it was installed.
void tell_installation() {
  std::error_code error;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
  if (!error) use_installation(program.parent_path().parent_path());
}

int failed(int code, const std::string& message, const std::string& hint = {}) {
  std::string text = "error: " + terminal_line(message) + "\n";
  if (!hint.empty()) text += "hint: " + terminal_line(hint) + "\n";
  to_standard_error(text);
  return code;
}

/// The same for people, and for programs that asked for it.
int failed(int code, const std::exception& error, const std::string& hint, bool json) {
  if (json) print_document(report::error_document(error, code));
  return failed(code, error.what(), hint);
}

int run_command_line(int count, char** arguments, bool asked_for_json) {
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
  add_render_command(app, exit_code);
  add_rank_command(app, exit_code);
  add_material_command(app);
  add_study_command(app, exit_code);
  add_validate_command(app, exit_code);
  add_setup_command(app, exit_code);
  add_doctor_command(app, exit_code);
  add_schema_command(app, exit_code);
  bool json = false;
  CLI::App* shown = app.add_subcommand("version", "version of this program and of its libraries");
  add_json_flag(*shown, json);
  shown->callback([&json] {
    if (json) return print_document(report::versions_document());
    for (const auto& [library, number] : versions()) fmt::print("{:10} {}\n", library, number);
  });
  refuse_blank_values(app);
  if (const std::string word = value_left_out(count, arguments); !word.empty())
    throw InvalidInput("found \"" + printable(word) + "\", expected a value behind the sign");
  try {
    app.parse(count, arguments);
  } catch (const CLI::ParseError& e) {
    if (e.get_exit_code() == 0) return app.exit(e);  // --help, --version
    const UsageError error = explain_usage(app, {arguments + 1, arguments + count}, e);
    if (asked_for_json)
      print_document(report::error_document(error.message, error.hint, kBadInput));
    return failed(kBadInput, error.message, error.hint);
  }
  return exit_code;
}

constexpr char kNoMemory[] = "not enough memory";
constexpr char kLessMemory[] = "a larger simulation.edge_length needs less";

/// Also where there was none for the stack of a thread.
bool is_want_of_memory(const std::exception& error) {
  if (dynamic_cast<const std::bad_alloc*>(&error)) return true;
  const auto* system = dynamic_cast<const std::system_error*>(&error);
  return system && (system->code() == std::errc::resource_unavailable_try_again ||
                    system->code() == std::errc::not_enough_memory);
}

/// An exception that nobody can catch, as one that leaves a destructor, ends the process. Of our
/// libraries only want of memory comes so far. Words and code are those of any other place.
[[noreturn]] void end_in_words() {
  try {
    if (const std::exception_ptr error = std::current_exception()) std::rethrow_exception(error);
  } catch (const std::exception& error) {
    if (is_want_of_memory(error)) {
      failed(kBadInput, kNoMemory, kLessMemory);
      _exit(kBadInput);
    }
    failed(kBadInput, std::string("unexpected: ") + error.what());
  } catch (...) {
  }
  std::abort();
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
  const bool json = asks_for_json(count, arguments);
  try {
    return run_command_line(count, arguments, json);
  } catch (const Cancelled&) {
    return failed(kInterrupted, Error("interrupted; nothing was written"), {}, json);
  } catch (const Interrupted& e) {
    return failed(kInterrupted, e, e.hint(), json);
  } catch (const SolverFailure& e) {
    return failed(kNotSettled, e, e.hint(), json);
  } catch (const Error& e) {
    return failed(kBadInput, e, e.hint(), json);
  } catch (const std::exception& e) {
    if (is_want_of_memory(e)) {
      const Error error(kNoMemory, kLessMemory);
      return failed(kBadInput, error, error.hint(), json);
    }
    if (std::ferror(stdout)) return kBadInput;  // fmt throws then; with_output_written tells
    const Error error(std::string("unexpected: ") + e.what(),
                      "this is a fault of Loosefit; please report it with the scenario");
    return failed(kNotSettled, error, error.hint(), json);
  }
}

}  // namespace
}  // namespace loosefit

int main(int count, char** arguments) {
  using namespace loosefit;
  hold_standard_streams();
  meet_limits_as_errors();
  tell_installation();
  disk_cache::turn_on(true);
  std::set_terminate(end_in_words);
  const ThreadLimit cores(0);
  const int exit_code = with_output_written(run_guarded(count, arguments));
  // Not through what libraries do at the end: it waits for threads of a shared BLAS, which ask for
  // memory for ever where there is none.
  std::fflush(nullptr);
  _exit(exit_code);
}

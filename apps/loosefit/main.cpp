#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <new>

#include "command_body.h"
#include "command_doctor.h"
#include "command_material.h"
#include "command_pattern.h"
#include "command_rank.h"
#include "command_run.h"
#include "command_stages.h"
#include "command_validate.h"
#include "exit_code.h"
#include "loosefit/base/error.h"
#include "loosefit/base/version.h"
#include "loosefit/solver/pin_blas.h"

namespace loosefit {
namespace {

int failed(int code, const std::string& message, const std::string& hint = {}) {
  fmt::print(stderr, "error: {}\n", message);
  if (!hint.empty()) fmt::print(stderr, "hint: {}\n", hint);
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
  add_doctor_command(app, exit_code);
  app.add_subcommand("version", "version of this program and of its libraries")->callback([] {
    for (const auto& [library, number] : versions()) fmt::print("{:10} {}\n", library, number);
  });
  try {
    app.parse(count, arguments);
  } catch (const CLI::ParseError& e) {
    if (e.get_exit_code() == 0) return app.exit(e);  // --help, --version
    return failed(kBadInput, e.what(), "loosefit --help, or loosefit COMMAND --help");
  }
  return exit_code;
}

}  // namespace
}  // namespace loosefit

int main(int count, char** arguments) {
  using namespace loosefit;
  pin_blas(arguments);
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
    return failed(kNotSettled, std::string("unexpected: ") + e.what(),
                  "this is a fault of Loosefit; please report it with the scenario");
  }
}

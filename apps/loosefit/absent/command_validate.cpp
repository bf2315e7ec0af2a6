#include "command_validate.h"

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include "loosefit/base/error.h"

namespace loosefit {

// Of a program that was built with LOOSEFIT_VALIDATE=OFF, as the first `make demo` does: the
// benchmarks are a fifth of its compilation.
void add_validate_command(CLI::App& app, int&) {
  CLI::App* command = app.add_subcommand(
      "validate", "carry out the benchmarks (not in this program: make validate builds them)");
  command->allow_extras();
  command->callback([] {
    throw InvalidInput("validate: found a program that was built without its benchmarks",
                       "make validate builds them, or cmake -DLOOSEFIT_VALIDATE=ON");
  });
}

}  // namespace loosefit

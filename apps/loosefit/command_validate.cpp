#include "command_validate.h"

#include <fmt/format.h>

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <cstdio>
#include <memory>
#include <optional>

#include "exit_code.h"
#include "loosefit/base/resources.h"
#include "loosefit/base/text.h"
#include "loosefit/validate/run_validation.h"
#include "loosefit/validate/validation_json.h"
#include "loosefit/validate/validation_table.h"
#include "loosefit/validate/write_validation.h"
#include "print_document.h"
#include "terminal_progress.h"

namespace loosefit {
namespace {

struct Arguments {
  std::string output;
  std::vector<std::string> only;
  bool quick = false, list = false, json = false;
};

void print_list(const std::vector<validate::Benchmark>& all) {
  for (const validate::Benchmark& b : all)
    fmt::print("{:4}{} {}\n    {}\n", b.id, b.in_quick ? "" : " (not in --quick)", b.title,
               b.reference);
}

int run_validate(const Arguments& arguments) {
  const validate::Effort effort =
      arguments.quick ? validate::Effort::quick : validate::Effort::full;
  const auto chosen = validate::select_benchmarks(validate::benchmarks(), arguments.only, effort);
  if (arguments.list) {
    arguments.json ? print_document(validate::benchmarks_json(chosen)) : print_list(chosen);
    return kGood;
  }
  TerminalProgress shown(false);
  InterruptGuard guard(shown);  // first: a folder that is begun must not be left behind
  std::optional<validate::ValidationOutput> output;
  if (!arguments.output.empty()) output.emplace(arguments.output);
  shown.stage("validate");
  // Memory and sense both end at a handful; machines with one core get one.
  const int workers = std::clamp(usable_threads(), 1, 8);
  const validate::Validation validation = validate::run_validation(
      chosen, effort, shown, workers, [&](const validate::BenchmarkOutcome& outcome) {
        shown.clear();
        if (arguments.json) return;
        fmt::print("{}\n", validate::outcome_table(outcome));
        std::fflush(stdout);
      });
  if (output) output->write(validation, shown);
  shown.clear();
  if (arguments.json) {
    print_document(validate::validation_json(validation));
    return validation.as_stated() ? kGood : kGateMissed;
  }
  if (output)
    fmt::print("wrote validation.html and validation.json into {}\n",
               terminal_line(arguments.output));
  fmt::print("{}\n", validate::verdict_line(validation));
  return validation.as_stated() ? kGood : kGateMissed;
}

}  // namespace

void add_validate_command(CLI::App& app, int& exit_code) {
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand(
      "validate", "hold the simulation against exact solutions and measured fabrics");
  command->add_option("-o,--output", arguments->output,
                      "folder for validation.json and validation.html: a new or empty one, or an "
                      "earlier one, of which only these are replaced");
  command->add_flag("--quick", arguments->quick, "the subset that fits into a minute");
  command->add_option("--only", arguments->only, "ids of benchmarks: B1,C2")->delimiter(',');
  command->add_flag("--list", arguments->list, "say what there is; run nothing");
  add_json_flag(*command, arguments->json);
  command->callback([arguments, &exit_code] { exit_code = run_validate(*arguments); });
}

}  // namespace loosefit

#include "command_run.h"

#include <fmt/format.h>

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <memory>

#include "cache_flag.h"
#include "exit_code.h"
#include "loosefit/base/text.h"
#include "loosefit/io/scenario.h"
#include "loosefit/report/ranking_output.h"
#include "loosefit/report/result_documents.h"
#include "loosefit/report/result_text.h"
#include "loosefit/report/run_into_folder.h"
#include "print_document.h"
#include "terminal_progress.h"

namespace loosefit {
namespace {

struct Arguments {
  std::string scenario, output;
  bool quiet = false, json = false, pictures = true;
  pipeline::RunOptions options;
};

int run(const Arguments& arguments) {
  const scenario::Scenario scenario = io::read_scenario(arguments.scenario);
  TerminalProgress shown(arguments.quiet);
  InterruptGuard guard(shown);
  const report::FolderOutput made = report::run_into_folder(
      scenario, arguments.output, arguments.options, arguments.pictures, shown);
  shown.clear();
  if (arguments.json) {
    print_document(report::run_document(made, arguments.output));
  } else if (!arguments.quiet) {
    fmt::print("{}written: {}\n", report::result_text(made.result),
               terminal_line(arguments.output));
    if (made.ranking) fmt::print("\n{}", report::ranking_text(*made.ranking));
  }
  return made.result.certificate().holds() ? kGood : kNotSettled;
}

CLI::App* add_command(CLI::App& app, const std::string& name, const std::string& description,
                      const std::shared_ptr<Arguments>& arguments, int& exit_code) {
  CLI::App* command = app.add_subcommand(name, description);
  command->add_option("SCENARIO", arguments->scenario, "scenario file (docs/scenario.md)")
      ->required();
  command
      ->add_option("-o,--output", arguments->output,
                   "folder to write: a new or empty one, or an earlier output, of which only "
                   "unchanged files of Loosefit are replaced")
      ->required();
  command->add_flag("-q,--quiet", arguments->quiet, "no progress, no result table");
  add_cache_flag(*command);
  add_json_flag(*command, arguments->json);
  command->callback([arguments, &exit_code] { exit_code = run(*arguments); });
  return command;
}

}  // namespace

void add_run_commands(CLI::App& app, int& exit_code) {
  auto whole = std::make_shared<Arguments>();
  CLI::App* command = add_command(app, "run", "whole pipeline: body, garment, drape, maps, report",
                                  whole, exit_code);
  command->add_flag("--allow-unsettled", whole->options.allow_unsettled,
                    "make maps even of a drape that did not settle or is not worn");
  command->add_flag("!--no-pictures", whole->pictures, "write no PNG files");

  auto drape = std::make_shared<Arguments>();
  drape->options.only_drape = true;
  add_command(app, "drape", "stop after the drape: no maps, sites, pictures or report", drape,
              exit_code);
}

}  // namespace loosefit

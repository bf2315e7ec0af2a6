#include "command_run.h"

#include <fmt/format.h>

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <memory>

#include "case_output.h"
#include "exit_code.h"
#include "loosefit/base/text.h"
#include "loosefit/io/run_folder.h"
#include "loosefit/io/run_log.h"
#include "loosefit/render/display.h"
#include "loosefit/report/ranking_output.h"
#include "loosefit/study/run_case.h"
#include "planned_files.h"
#include "terminal_progress.h"

namespace loosefit {
namespace {

struct Arguments {
  std::string scenario, output;
  bool quiet = false, pictures = true;
  RunOptions options;
};

int run(const Arguments& arguments) {
  const Scenario scenario = read_scenario(arguments.scenario);
  const bool pictures = arguments.pictures && !arguments.options.only_drape;
  if (pictures) check_display();  // say so now, not after the simulation
  TerminalProgress shown(arguments.quiet);
  InterruptGuard guard(shown);  // first: a folder that is begun must not be left behind
  RunFolder folder = RunFolder::create(arguments.output);
  folder.announce(planned_files(scenario, {.log = true,
                                           .sites = !arguments.options.only_drape,
                                           .pictures = pictures,
                                           .report = !arguments.options.only_drape}));
  RunLog log(folder.path() / "log.jsonl", shown);
  CaseResult result = run_case(scenario, log, arguments.options);
  const std::optional<RankingTable> ranking = rank_as_asked(folder.path(), result, log);
  write_output(folder.path(), result,
               {.pictures = pictures,
                .report = !arguments.options.only_drape,
                .ranking = ranking ? &*ranking : nullptr},
               log);
  for (const std::string& warning : result.warnings) log.warning(warning);
  const Certificate& certificate = result.drape.certificate;
  log.end(certificate.holds()     ? "settled"
          : certificate.settled() ? "not worn: " + join(certificate.worn_reasons, "; ")
                                  : "not settled");
  folder.commit();
  shown.clear();
  if (!arguments.quiet) {
    print_result(result, arguments.output);
    if (ranking) fmt::print("\n{}", ranking_text(*ranking));
  }
  return certificate.holds() ? kGood : kNotSettled;
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
  command->add_flag("!--no-pictures", whole->pictures, "write no PNG files (needs no display)");

  auto drape = std::make_shared<Arguments>();
  drape->options.only_drape = true;
  add_command(app, "drape", "stop after the drape: no maps, sites, pictures or report", drape,
              exit_code);
}

}  // namespace loosefit

#include "command_stages.h"

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <memory>
#include <optional>

#include "case_output.h"
#include "exit_code.h"
#include "loosefit/io/run_folder.h"
#include "loosefit/render/display.h"
#include "loosefit/study/case_stages.h"
#include "loosefit/study/load_case.h"
#include "planned_files.h"
#include "terminal_progress.h"

namespace loosefit {
namespace {

struct Arguments {
  std::string folder;
  std::vector<std::string> maps;  ///< instead of the scenario's
  bool allow_unsettled = false, quiet = false;
};

/// Takes an earlier output up again, redoes the stages from maps on, and replaces their files.
int redo(const Arguments& arguments, const OutputOptions& output) {
  if (output.pictures) check_display();
  TerminalProgress shown(arguments.quiet);
  InterruptGuard guard(shown);  // first: a folder that is begun must not be left behind
  RunFolder folder = RunFolder::update(arguments.folder);
  folder.leave_if_edited("scenario.toml");
  CaseResult result = load_case(arguments.folder, shown);
  if (!arguments.maps.empty()) result.scenario.output.maps = arguments.maps;
  folder.announce(
      planned_files(result.scenario, {.pictures = output.pictures, .report = output.report}));
  StageClock clock(shown);
  clock.stage("maps");
  add_maps(result, arguments.allow_unsettled);
  clock.stage("placement");
  add_sites(result);
  keep_known_repeats(result);
  clock.stop();
  result.seconds.insert(result.seconds.end(), clock.entries().begin(), clock.entries().end());
  result.warnings = collected_warnings(result);
  OutputOptions whole = output;
  std::optional<RankingTable> ranking;
  if (output.report) ranking = rank_as_asked(folder.path(), result, shown);
  if (ranking) whole.ranking = &*ranking;
  write_output(folder.path(), result, whole, shown);
  folder.commit();
  shown.clear();
  if (!arguments.quiet) print_result(result, arguments.folder);
  tell_what_was_set_aside(arguments.folder, folder.aside());
  return result.drape.certificate.holds() ? kGood : kNotSettled;
}

void add_stage(CLI::App& app, const std::string& name, const std::string& description,
               const OutputOptions& output, int& exit_code) {
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand(name, description);
  command->add_option("DIR", arguments->folder, "folder of an earlier run or drape")->required();
  command
      ->add_option("--map", arguments->maps,
                   "what to map, instead of the scenario's maps; may be repeated")
      ->check(CLI::IsMember(map_names()))
      ->allow_extra_args(false);
  command->add_flag("--allow-unsettled", arguments->allow_unsettled,
                    "make maps even of a drape that did not settle or is not worn");
  command->add_flag("-q,--quiet", arguments->quiet, "no progress, no result table");
  command->callback([arguments, output, &exit_code] { exit_code = redo(*arguments, output); });
}

}  // namespace

void add_stage_commands(CLI::App& app, int& exit_code) {
  add_stage(app, "map", "make maps and sites of a drape again", {false, false}, exit_code);
  add_stage(app, "render", "maps, sites and pictures of a drape again", {true, false}, exit_code);
  add_stage(app, "report", "maps, sites, pictures and report.html of a drape again", {true, true},
            exit_code);
}

}  // namespace loosefit

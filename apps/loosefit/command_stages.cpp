#include "command_stages.h"

#include <fmt/format.h>

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <memory>

#include "exit_code.h"
#include "loosefit/base/text.h"
#include "loosefit/maps/compute_maps.h"
#include "loosefit/report/result_documents.h"
#include "loosefit/report/result_text.h"
#include "print_document.h"
#include "set_aside_note.h"
#include "terminal_progress.h"

namespace loosefit {
int redo_stage(const StageArguments& arguments) {
  TerminalProgress shown(arguments.quiet);
  InterruptGuard guard(shown);
  const report::FolderOutput made =
      report::redo_in_folder(arguments.folder, arguments.options, shown);
  shown.clear();
  if (arguments.json)
    print_document(report::run_document(made, arguments.folder));
  else if (!arguments.quiet)
    fmt::print("{}written: {}\n", report::result_text(made.result),
               terminal_line(arguments.folder));
  note_what_was_set_aside(arguments.folder, made.set_aside);
  return made.result.certificate().holds() ? kGood : kNotSettled;
}

namespace {

void add_stage(CLI::App& app, const std::string& name, const std::string& description,
               const report::RedoOptions& options, int& exit_code) {
  auto arguments = std::make_shared<StageArguments>();
  arguments->options = options;
  CLI::App* command = app.add_subcommand(name, description);
  command->add_option("DIR", arguments->folder, "folder of an earlier run or drape")->required();
  command
      ->add_option("--map", arguments->options.maps,
                   "what to map, instead of the scenario's maps; may be repeated")
      ->check(CLI::IsMember(maps::map_names()))
      ->allow_extra_args(false);
  command->add_flag("--allow-unsettled", arguments->options.allow_unsettled,
                    "make maps even of a drape that did not settle or is not worn");
  command->add_flag("-q,--quiet", arguments->quiet, "no progress, no result table");
  add_json_flag(*command, arguments->json);
  command->callback([arguments, &exit_code] { exit_code = redo_stage(*arguments); });
}

}  // namespace

void add_stage_commands(CLI::App& app, int& exit_code) {
  add_stage(app, "map", "make maps and sites of a drape again",
            {.pictures = false, .report = false}, exit_code);
  add_stage(app, "report", "maps, sites, pictures and report.html of a drape again",
            {.pictures = true, .report = true}, exit_code);
}

}  // namespace loosefit

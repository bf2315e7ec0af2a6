#include "command_rank.h"

#include <fmt/format.h>

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <memory>

#include "exit_code.h"
#include "loosefit/base/text.h"
#include "loosefit/io/scorecard_file.h"
#include "loosefit/placement/site_search.h"
#include "loosefit/report/rank_runs.h"
#include "loosefit/report/ranking_output.h"
#include "loosefit/report/result_documents.h"
#include "print_document.h"
#include "set_aside_note.h"
#include "terminal_progress.h"

namespace loosefit {
namespace {

struct Arguments {
  std::vector<std::string> inputs;
  std::string modality, output;
  bool sites = false, partial = false, allow_unsettled = false, quiet = false, json = false;
  int best = 0;
  double spacing_mm = 50, seam_mm = 10, edge_mm = 10;
  std::vector<std::string> keep_out, regions;
  unsigned seed = 1;
};

placement::RankingWish wish_of(const Arguments& arguments) {
  placement::RankingWish wish;
  wish.scorecard = io::load_scorecard(arguments.modality);
  wish.best = arguments.best;
  wish.partial = arguments.partial;
  wish.constraints.spacing = 1e-3 * arguments.spacing_mm;
  wish.constraints.seam_clearance = 1e-3 * arguments.seam_mm;
  wish.constraints.edge_clearance = 1e-3 * arguments.edge_mm;
  for (const std::string& text : arguments.keep_out)
    placement::add_keep_out(text, wish.constraints.keep_out);
  for (const std::string& region : arguments.regions)
    wish.constraints.regions.push_back(*body::find_region(region));
  wish.search.seed = wish.rank.seed = arguments.seed;
  return wish;
}

int rank(const Arguments& arguments) {
  report::RankRuns asked;
  asked.inputs = arguments.inputs;
  asked.wish = wish_of(arguments);
  asked.with_sites = arguments.sites || arguments.best == 0;
  asked.allow_unsettled = arguments.allow_unsettled;
  asked.output = arguments.output;
  TerminalProgress shown(arguments.quiet);
  InterruptGuard guard(shown);
  const report::RankedRuns ranked =
      report::rank_runs(asked, shown, [&](const placement::RankingTable& table) {
        shown.clear();
        if (!arguments.quiet && !arguments.json) fmt::print("{}", report::ranking_text(table));
      });
  note_what_was_set_aside(ranked.folder, ranked.set_aside);
  if (arguments.json) {
    print_document(report::rank_document(ranked));
  } else if (!arguments.quiet) {
    if (ranked.folder.empty())
      fmt::print("no files written: give a folder with -o\n");
    else
      fmt::print("written: {}\n", terminal_line(ranked.folder));
  }
  return ranked.all_hold ? kGood : kNotSettled;
}

}  // namespace

void add_rank_command(CLI::App& app, int& exit_code) {
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand(
      "rank", "rank the sites of a run for a kind of sensor, or search the best places for it");
  command
      ->add_option("DIR|SCENARIO", arguments->inputs,
                   "folder of an earlier run or drape, or a scenario file, which is run first; "
                   "several are samples of one population")
      ->required();
  command
      ->add_option("-m,--modality", arguments->modality,
                   "scorecard: a name (docs/scorecards.md) or the path of a .toml file")
      ->required();
  command->add_flag("--sites", arguments->sites,
                    "rank the scenario's sites and the presets (default without --best)");
  command->add_option("--best", arguments->best, "search for the best K places")
      ->check(CLI::Range(1, placement::kMostPlaces));
  command->add_option("--spacing", arguments->spacing_mm, "between found places, mm (default 50)")
      ->check(CLI::Range(0.0, 1e3 * placement::kLargestClearance));
  command->add_option("--seam", arguments->seam_mm, "sensor to seams, mm (default 10)")
      ->check(CLI::Range(0.0, 1e3 * placement::kLargestClearance));
  command->add_option("--edge", arguments->edge_mm, "sensor to hems and openings, mm (default 10)")
      ->check(CLI::Range(0.0, 1e3 * placement::kLargestClearance));
  command
      ->add_option("--keep-out", arguments->keep_out,
                   "PANEL:u,v,u,v or PANEL:u,v,radius in metres, or a body region; may be repeated")
      ->allow_extra_args(false);
  command
      ->add_option(
          "--region", arguments->regions,
          "search only over this part of the body (default: what the scorecard names); may "
          "be repeated")
      ->check(CLI::IsMember(body::region_names()))
      ->allow_extra_args(false);
  command->add_flag("--partial", arguments->partial,
                    "judge by what one drape can tell; scores are upper bounds");
  command->add_option("--seed", arguments->seed, "of candidates and bootstrap (default 1)");
  command->add_option("-o,--output", arguments->output,
                      "folder for ranking-NAME.csv, .json and sewing-plan-NAME.svg, NAME that of "
                      "the scorecard (default: DIR, if it is one)");
  command->add_flag("--allow-unsettled", arguments->allow_unsettled,
                    "rank even by a drape that did not settle or is not worn");
  command->add_flag("-q,--quiet", arguments->quiet, "no progress, no table");
  add_json_flag(*command, arguments->json);
  command->callback([arguments, &exit_code] { exit_code = rank(*arguments); });
}

}  // namespace loosefit

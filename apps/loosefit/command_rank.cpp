#include "command_rank.h"

#include <fmt/format.h>

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <filesystem>
#include <memory>

#include "exit_code.h"
#include "loosefit/base/error.h"
#include "loosefit/io/run_folder.h"
#include "loosefit/io/scorecard_file.h"
#include "loosefit/report/ranking_output.h"
#include "loosefit/study/case_stages.h"
#include "loosefit/study/load_case.h"
#include "loosefit/study/rank_case.h"
#include "loosefit/study/run_case.h"
#include "terminal_progress.h"

namespace loosefit {
namespace {

struct Arguments {
  std::string input, modality, output;
  bool sites = false, partial = false, allow_unsettled = false, quiet = false;
  int best = 0;
  double spacing_mm = 50, seam_mm = 10, edge_mm = 10;
  std::vector<std::string> keep_out, regions;
  unsigned seed = 1;
};

RankingWish wish_of(const Arguments& arguments) {
  RankingWish wish;
  wish.scorecard = load_scorecard(arguments.modality);
  wish.best = arguments.best;
  wish.partial = arguments.partial;
  wish.constraints.spacing = 1e-3 * arguments.spacing_mm;
  wish.constraints.seam_clearance = 1e-3 * arguments.seam_mm;
  wish.constraints.edge_clearance = 1e-3 * arguments.edge_mm;
  for (const std::string& text : arguments.keep_out) add_keep_out(text, wish.constraints.keep_out);
  for (const std::string& region : arguments.regions)
    wish.constraints.regions.push_back(*find_region(region));
  wish.search.seed = wish.rank.seed = arguments.seed;
  return wish;
}

/// The drape to be judged: an earlier output, or a scenario that is run now.
CaseResult drape_of(const Arguments& arguments, Progress& progress) {
  if (!std::filesystem::is_directory(arguments.input)) {
    RunOptions options;
    options.allow_unsettled = arguments.allow_unsettled;
    options.only_drape = true;
    return run_case(read_scenario(arguments.input), progress, options);
  }
  return load_case(arguments.input, progress);
}

int rank(const Arguments& arguments) {
  RankingWish wish = wish_of(arguments);
  TerminalProgress shown(arguments.quiet);
  InterruptGuard guard(shown);  // first: a folder that is begun must not be left behind
  const bool folder_given = std::filesystem::is_directory(arguments.input);
  const bool beside = folder_given && arguments.output.empty();
  std::optional<RunFolder> run;
  if (beside) run.emplace(RunFolder::update(arguments.input));
  if (!arguments.output.empty()) make_plain_folder(arguments.output);

  CaseResult result = drape_of(arguments, shown);
  StageClock clock(shown);
  clock.stage("maps");
  result.maps = make_maps(result, arguments.allow_unsettled);
  clock.stage("placement");
  if (arguments.sites || wish.best == 0) wish.sites = make_sites(result);
  wish.progress = [&clock](double share) {
    clock.check_cancelled();
    clock.update(share, "search");
  };
  const RankingTable table = rank_case(result, wish);
  clock.stop();
  shown.clear();
  if (!arguments.quiet) fmt::print("{}", ranking_text(table));
  if (beside) {
    write_ranking(run->path(), table);
    run->commit();
  }
  if (!arguments.output.empty()) write_ranking(arguments.output, table);
  if (!arguments.quiet && (beside || !arguments.output.empty()))
    fmt::print("written: {}\n", beside ? arguments.input : arguments.output);
  return result.drape.certificate.settled() ? kGood : kNotSettled;
}

}  // namespace

void add_rank_command(CLI::App& app, int& exit_code) {
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand(
      "rank", "rank the sites of a run for a kind of sensor, or search the best places for it");
  command
      ->add_option("DIR|SCENARIO", arguments->input,
                   "folder of an earlier run or drape, or a scenario file, which is run first")
      ->required();
  command
      ->add_option("-m,--modality", arguments->modality,
                   "scorecard: a name (docs/scorecards.md) or the path of a .toml file")
      ->required();
  command->add_flag("--sites", arguments->sites,
                    "rank the scenario's sites and the presets (default without --best)");
  command->add_option("--best", arguments->best, "search for the best K places")
      ->check(CLI::Range(1, 1000));
  command->add_option("--spacing", arguments->spacing_mm, "between found places, mm (default 50)")
      ->check(CLI::Range(0.0, 10000.0));
  command->add_option("--seam", arguments->seam_mm, "sensor to seams, mm (default 10)")
      ->check(CLI::Range(0.0, 10000.0));
  command->add_option("--edge", arguments->edge_mm, "sensor to hems and openings, mm (default 10)")
      ->check(CLI::Range(0.0, 10000.0));
  command
      ->add_option("--keep-out", arguments->keep_out,
                   "PANEL:u,v,u,v or PANEL:u,v,radius in metres, or a body region; may be repeated")
      ->allow_extra_args(false);
  command
      ->add_option(
          "--region", arguments->regions,
          "search only over this part of the body (default: what the scorecard names); may "
          "be repeated")
      ->check(CLI::IsMember(region_names()))
      ->allow_extra_args(false);
  command->add_flag("--partial", arguments->partial,
                    "judge by what one drape can tell; scores are upper bounds");
  command->add_option("--seed", arguments->seed, "of candidates and bootstrap (default 1)");
  command->add_option("-o,--output", arguments->output,
                      "folder for ranking.csv and ranking.json (default: DIR)");
  command->add_flag("--allow-unsettled", arguments->allow_unsettled,
                    "rank even by a drape that did not settle");
  command->add_flag("-q,--quiet", arguments->quiet, "no progress, no table");
  command->callback([arguments, &exit_code] { exit_code = rank(*arguments); });
}

}  // namespace loosefit

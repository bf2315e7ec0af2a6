#include "command_rank.h"

#include <fmt/format.h>

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <deque>
#include <filesystem>
#include <memory>
#include <set>

#include "case_output.h"
#include "exit_code.h"
#include "loosefit/base/error.h"
#include "loosefit/base/text.h"
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
  std::vector<std::string> inputs;
  std::string modality, output;
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

/// The drape to be judged: an earlier output, or a scenario that is run now; with its maps.
CaseResult drape_of(const std::string& input, const Arguments& arguments, Progress& progress) {
  CaseResult result;
  if (std::filesystem::is_directory(input)) {
    result = load_case(input, progress);
  } else {
    RunOptions options;
    options.allow_unsettled = arguments.allow_unsettled;
    options.only_drape = true;
    result = run_case(read_scenario(input), progress, options);
  }
  progress.stage("maps");
  try {
    add_maps(result, arguments.allow_unsettled);
  } catch (const Error& error) {
    if (result.drape.certificate.holds()) throw;
    throw Error(input + ": " + error.what(), error.hint());  // which of several
  }
  return result;
}

/// Last part of a path: "run3" of "out/run3/".
std::string last_part(const std::string& input) {
  const std::filesystem::path path = std::filesystem::path(input).lexically_normal();
  return path.has_filename() ? path.filename().string() : path.parent_path().filename().string();
}

/// Short names of the inputs, or the inputs themselves where two would be called alike.
/// \throws InvalidInput for the same input twice, which would count as two samples.
std::vector<std::string> names_of(const std::vector<std::string>& inputs) {
  std::set<std::filesystem::path> places;
  std::set<std::string> different;
  std::vector<std::string> names;
  for (const std::string& input : inputs) {
    std::error_code error;
    if (!places.insert(std::filesystem::weakly_canonical(input, error)).second)
      throw InvalidInput({"", 0, "DIR"}, printable(input) + " twice", "every run once",
                         "each run counts as a sample of its own");
    names.push_back(last_part(input));
    different.insert(names.back());
  }
  return different.size() == inputs.size() ? names : inputs;
}

int rank(const Arguments& arguments) {
  RankingWish wish = wish_of(arguments);
  const std::vector<std::string> names = names_of(arguments.inputs);
  TerminalProgress shown(arguments.quiet);
  InterruptGuard guard(shown);  // first: a folder that is begun must not be left behind
  const std::string& input = arguments.inputs.front();
  const bool beside = arguments.inputs.size() == 1 && std::filesystem::is_directory(input) &&
                      arguments.output.empty();
  std::optional<RunFolder> folder;
  if (beside) folder.emplace(RunFolder::update(input, "ranking"));
  if (!arguments.output.empty()) folder.emplace(RunFolder::add(arguments.output, "ranking"));
  if (folder) folder->announce(ranking_files(wish.scorecard.name));

  std::deque<CaseResult> results;
  std::vector<RankedRun> runs;
  for (std::size_t i = 0; i < names.size(); ++i) {
    results.push_back(drape_of(arguments.inputs[i], arguments, shown));
    runs.push_back({names[i], &results.back()});
  }
  StageClock clock(shown);
  clock.stage("placement");
  wish.progress = [&clock](double share) {
    clock.check_cancelled();
    clock.update(share, "search");
  };
  const RankingTable table = rank_cases(runs, wish, arguments.sites || wish.best == 0);
  clock.stop();
  shown.clear();
  if (!arguments.quiet) fmt::print("{}", ranking_text(table));
  const Pattern& pattern = results.front().pattern.pattern;
  if (folder) {
    write_ranking(folder->path(), table, pattern);
    folder->commit();
    tell_what_was_set_aside(input, folder->aside());
  }
  if (!arguments.quiet) {
    if (folder)
      fmt::print("written: {}\n", terminal_line(beside ? input : arguments.output));
    else
      fmt::print("no files written: give a folder with -o\n");
  }
  const bool settled = std::all_of(results.begin(), results.end(), [](const CaseResult& result) {
    return result.drape.certificate.holds();
  });
  return settled ? kGood : kNotSettled;
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
                      "folder for ranking-NAME.csv, .json and sewing-plan-NAME.svg, NAME that of "
                      "the scorecard (default: DIR, if it is one)");
  command->add_flag("--allow-unsettled", arguments->allow_unsettled,
                    "rank even by a drape that did not settle or is not worn");
  command->add_flag("-q,--quiet", arguments->quiet, "no progress, no table");
  command->callback([arguments, &exit_code] { exit_code = rank(*arguments); });
}

}  // namespace loosefit

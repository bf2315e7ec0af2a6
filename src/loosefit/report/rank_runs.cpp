#include "loosefit/report/rank_runs.h"

#include <algorithm>
#include <deque>
#include <filesystem>
#include <optional>
#include <set>

#include "loosefit/base/error.h"
#include "loosefit/base/stage_clock.h"
#include "loosefit/base/text.h"
#include "loosefit/io/run_folder.h"
#include "loosefit/io/scenario.h"
#include "loosefit/pipeline/case_lines.h"
#include "loosefit/pipeline/load_case.h"
#include "loosefit/pipeline/map_case.h"
#include "loosefit/pipeline/rank_case.h"
#include "loosefit/pipeline/run_case.h"
#include "loosefit/report/ranking_output.h"

namespace loosefit::report {
namespace {

/// The drape to be judged: an earlier output, or a scenario that is run first; with its maps.
pipeline::CaseResult mapped_case(const std::string& input, bool allow_unsettled,
                                 Progress& progress) {
  pipeline::CaseResult result;
  if (std::filesystem::is_directory(input)) {
    result = pipeline::load_case(input, progress);
  } else {
    pipeline::RunOptions options;
    options.allow_unsettled = allow_unsettled;
    options.only_drape = true;
    result = pipeline::run_case(io::read_scenario(input), progress, options);
  }
  progress.stage("maps");
  try {
    result.take_maps(pipeline::map_case(result, allow_unsettled));
  } catch (const Error& error) {
    if (result.certificate().holds()) throw;
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
std::vector<std::string> names_of(const std::vector<std::string>& inputs) {
  std::set<std::filesystem::path> known;
  std::set<std::string> different;
  std::vector<std::string> names;
  for (const std::string& input : inputs) {
    std::error_code error;
    if (!known.insert(std::filesystem::weakly_canonical(input, error)).second)
      throw InvalidInput({"", 0, "DIR"}, printable(input) + " twice", "every run once",
                         "each run counts as a sample of its own");
    names.push_back(last_part(input));
    different.insert(names.back());
  }
  return different.size() == inputs.size() ? names : inputs;
}

/// Where the files of the ranking go, if anywhere.
std::string folder_of(const RankRuns& asked) {
  if (!asked.output.empty()) return asked.output;
  const bool one_folder =
      asked.inputs.size() == 1 && std::filesystem::is_directory(asked.inputs.front());
  return one_folder ? asked.inputs.front() : std::string();
}

}  // namespace

RankedRuns rank_runs(const RankRuns& asked, Progress& progress,
                     const std::function<void(const placement::RankingTable&)>& before_writing) {
  // What can fail early does so before the runs.
  const std::vector<std::string> names = names_of(asked.inputs);
  RankedRuns ranked;
  ranked.folder = folder_of(asked);
  std::optional<io::RunFolder> files;
  if (!ranked.folder.empty()) {
    files.emplace(asked.output.empty() ? io::RunFolder::update(ranked.folder, "ranking")
                                       : io::RunFolder::add(ranked.folder, "ranking"));
    files->announce(ranking_files(asked.wish.scorecard.name));
  }

  std::deque<pipeline::CaseResult> results;
  std::vector<pipeline::RankedRun> runs;
  for (std::size_t i = 0; i < names.size(); ++i) {
    results.push_back(mapped_case(asked.inputs[i], asked.allow_unsettled, progress));
    runs.push_back({names[i], &results.back()});
  }

  StageClock clock(progress);
  clock.stage("placement");
  placement::RankingWish wish = asked.wish;
  wish.progress = [&clock](double share) {
    clock.check_cancelled();
    clock.update(share, "search");
  };
  ranked.table = pipeline::rank_cases(runs, wish, asked.with_sites);
  clock.stop();
  ranked.all_hold = std::ranges::all_of(
      results, [](const pipeline::CaseResult& result) { return result.certificate().holds(); });

  if (before_writing) before_writing(ranked.table);
  if (files) {
    pipeline::CaseResult& first = results.front();
    first.take_lines(pipeline::measure_lines(first));
    write_ranking(files->path(), ranked.table, first.studied().pattern.pattern,
                  first.lines.empty() ? nullptr : &first);
    files->commit();
    ranked.set_aside = files->aside();
  }
  return ranked;
}

}  // namespace loosefit::report

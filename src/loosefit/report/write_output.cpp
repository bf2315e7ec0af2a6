#include "loosefit/report/write_output.h"

#include <tbb/task_group.h>

#include "loosefit/base/resources.h"
#include "loosefit/base/stage_clock.h"
#include "loosefit/io/scorecard_file.h"
#include "loosefit/io/text_file.h"
#include "loosefit/pipeline/answers.h"
#include "loosefit/pipeline/case_files.h"
#include "loosefit/pipeline/case_folders.h"
#include "loosefit/pipeline/rank_case.h"
#include "loosefit/pipeline/wear_states.h"
#include "loosefit/report/case_pictures.h"
#include "loosefit/report/ranking_output.h"
#include "loosefit/report/write_lines.h"
#include "loosefit/report/write_model.h"
#include "loosefit/report/write_report.h"

namespace loosefit::report {
namespace {

using Path = std::filesystem::path;

void append(std::vector<Path>& files, const std::vector<Path>& more) {
  files.insert(files.end(), more.begin(), more.end());
}

/// What write_case_files writes of garments under the studied one and of states.
std::vector<Path> planned_drapes(const scenario::Scenario& scenario) {
  const int under = static_cast<int>(scenario.worn_under().size());
  std::vector<Path> files;
  for (int g = 0; g < under; ++g)
    append(files,
           {pipeline::under_folder(g) / "drape.vtp", pipeline::under_folder(g) / "pattern.json"});
  const pipeline::CaseWear wear = pipeline::plan_wear(scenario);
  for (const pipeline::StateId& id : pipeline::planned_states(wear)) {
    const Path folder = pipeline::state_folder(id, wear.postures[id.posture]);
    files.push_back(folder / "drape.vtp");
    if (id.in_first_donning()) files.push_back(folder / "body.vtp");
    for (int g = 0; g < under; ++g)
      files.push_back(folder / pipeline::under_folder(g) / "drape.vtp");
  }
  return files;
}

}  // namespace

std::vector<std::string> planned_files(const scenario::Scenario& scenario,
                                       const OutputParts& parts) {
  std::vector<Path> files = {"summary.json", "drape.vtp", "body.vtp", "pattern.json",
                             "scenario.toml"};
  append(files, planned_drapes(scenario));
  if (!pipeline::planned_states(pipeline::plan_wear(scenario)).empty())
    files.push_back(pipeline::kSeriesFile);
  files.push_back(kModelFile);
  if (parts.pictures) append(files, planned_pictures(scenario));
  if (parts.log) files.push_back("log.jsonl");
  if (parts.sites) files.push_back("sites.csv");
  if (parts.sites)
    for (const placement::SiteSpec& site : scenario.sites)
      if (site.line) {
        append(files, {"lines.csv", kLinesPlan, kLinesDxf, kLinesCables});
        break;
      }
  if (parts.report) files.push_back("report.html");
  if (parts.report && !scenario.ranking.modality.empty())
    for (const std::string& file :
         ranking_files(io::load_scorecard(scenario.ranking.modality).name))
      files.emplace_back(file);
  std::vector<std::string> names;
  for (const Path& file : files) names.push_back(file.generic_string());
  return names;
}

std::optional<TimedRanking> rank_as_asked(pipeline::CaseResult& result, Progress& progress) {
  result.answers.clear();
  if (result.studied().maps.maps.empty()) return {};
  StageClock clock(progress);
  clock.stage("placement");
  std::optional<TimedRanking> ranking;
  if (!result.scenario.ranking.modality.empty()) {
    placement::RankingWish wish =
        pipeline::ranking_wish(result.scenario.ranking, result.scenario.simulation.seed);
    wish.progress = [&clock](double share) {
      clock.check_cancelled();
      clock.update(share, "search");
    };
    ranking = TimedRanking{pipeline::rank_cases({{"run", &result}}, wish, true)};
  }
  result.answers = pipeline::make_answers(result, ranking ? &ranking->table : nullptr);
  clock.stop();
  if (ranking) ranking->seconds = clock.entries().front().seconds;
  return ranking;
}

pipeline::CaseResult write_output(const Path& folder, pipeline::CaseResult result,
                                  const OutputParts& parts,
                                  const std::optional<TimedRanking>& ranking, Progress& progress) {
  StageClock clock(progress);
  clock.stage("report");
  if (ranking) {
    write_ranking(folder, ranking->table, result.studied().pattern.pattern,
                  result.lines.empty() ? nullptr : &result);
    for (StageClock::Entry& entry : result.seconds)
      if (entry.stage == "placement") entry.seconds += ranking->seconds;
  }
  const CaseForms forms(result);
  tbb::task_group beside;  // no picture needs what these write
  beside.run([&] {
    forms.in_studied();
    pipeline::write_case_files(folder, result);
    write_model(folder, result, forms);
    if (!result.lines.empty()) write_lines(folder, result);
  });
  std::vector<render::Picture> pictures;
  std::string no_screen;
  if (parts.pictures) {
    try {
      pictures = draw_case(folder, result, forms, clock);
    } catch (const render::NoScreen& none) {
      no_screen = std::string(none.what()) + "; " + none.hint();
    }
  }
  beside.wait();
  if (!no_screen.empty()) result.warnings.push_back(no_screen);  // all else can be had without
  if (parts.report)
    write_report(folder, result, forms, pictures, ranking ? &ranking->table : nullptr);
  clock.stop();
  result.seconds.push_back({"report", clock.entries().front().seconds});
  result.peak_memory_mb = peak_memory_mb();
  pipeline::write_summary_file(folder, result);
  return result;
}

}  // namespace loosefit::report

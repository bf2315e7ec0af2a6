#include "case_output.h"

#include <fmt/format.h>

#include "loosefit/base/resources.h"
#include "loosefit/base/stage_clock.h"
#include "loosefit/base/text.h"
#include "loosefit/render/render_pictures.h"
#include "loosefit/report/ranking_output.h"
#include "loosefit/report/write_report.h"
#include "loosefit/study/case_files.h"
#include "loosefit/study/case_layers.h"
#include "loosefit/study/rank_case.h"
#include "loosefit/study/wear_states.h"

namespace loosefit {
namespace {

std::vector<Picture> draw(const std::filesystem::path& folder, const CaseResult& result,
                          Progress& progress) {
  const ScenarioOutput& wished = result.scenario.output;
  PictureOptions options;
  options.width = wished.width;
  options.height = wished.height;
  options.undecorated = wished.undecorated;
  options.views.clear();
  for (const std::string& view : wished.views) options.views.push_back(view_from_name(view));
  std::vector<PerformanceMap> maps;
  for (const CaseMap& entry : result.maps.maps) maps.push_back(entry.map);
  std::filesystem::create_directories(folder / "maps");
  if (options.undecorated)
    for (const CaseState& state : result.wear.states)
      if (state.donning == 0 && !state.drape.positions.empty()) {
        progress.check_cancelled();
        options.under = under_surface(result, &state);
        render_pictures(folder / state_folder(state), *result.wear.bodies[state.posture],
                        result.mesh(), state.drape.positions, {}, options);
      }
  for (int l = 0; l < static_cast<int>(result.under.size()); ++l) {
    progress.check_cancelled();
    const CaseUnder& under = result.under[l];
    std::vector<PerformanceMap> own;
    for (const CaseMap& entry : under.maps.maps) own.push_back(entry.map);
    options.under = {};
    render_pictures(folder / under_folder(l), result.body.body, under.mesh(), under.drape.positions,
                    own, options);
  }
  options.under = under_surface(result);
  return render_pictures(folder / "maps", result.body.body, result.mesh(), result.drape.positions,
                         maps, options, [&progress](double share) {
                           progress.check_cancelled();
                           progress.update(share, "pictures");
                         });
}

std::string number_or_dash(double value) {
  return value == value ? fmt::format("{:10.4g}", value) : fmt::format("{:>10}", "-");
}

}  // namespace

std::optional<RankingTable> rank_as_asked(const std::filesystem::path& folder, CaseResult& result,
                                          Progress& progress) {
  if (result.scenario.ranking.modality.empty() || result.maps.maps.empty()) return {};
  StageClock clock(progress);
  clock.stage("placement");
  RankingWish wish = ranking_wish(result.scenario.ranking, result.scenario.simulation.seed);
  wish.progress = [&clock](double share) {
    clock.check_cancelled();
    clock.update(share, "search");
  };
  RankingTable table = rank_cases({{"run", &result}}, wish, true);
  write_ranking(folder, table, result.pattern.pattern);
  clock.stop();
  for (StageClock::Entry& entry : result.seconds)
    if (entry.stage == "placement") entry.seconds += clock.entries().front().seconds;
  return table;
}

void write_output(const std::filesystem::path& folder, CaseResult& result,
                  const OutputOptions& options, Progress& progress) {
  StageClock clock(progress);
  clock.stage("report");
  write_case_files(folder, result);
  std::vector<Picture> pictures;
  if (options.pictures) pictures = draw(folder, result, clock);
  if (options.report) write_report(folder, result, pictures, options.ranking);
  clock.stop();
  result.seconds.push_back({"report", clock.entries().front().seconds});
  result.peak_memory_mb = peak_memory_mb();
  write_summary_file(folder, result);
}

void tell_what_was_set_aside(const std::string& folder, const std::string& aside) {
  if (aside.empty()) return;
  fmt::print(stderr, "note: files that stood in the way are in {}\n",
             terminal_line((std::filesystem::path(folder) / aside).string()));
}

void print_result(const CaseResult& result, const std::string& folder) {
  const Certificate& certificate = result.drape.certificate;
  for (const std::string& warning : result.warnings)
    fmt::print("warning: {}\n", terminal_line(warning));
  fmt::print("{}: residual {:.2e}, intersections body {} self {} ({})\n",
             certificate.settled() ? "settled" : "NOT SETTLED", certificate.residual,
             certificate.intersections_body, certificate.intersections_self,
             terminal_line(certificate.stop_reason));
  if (certificate.worn())
    fmt::print("worn: every limb goes through its opening, and no opening has left its place\n");
  else
    fmt::print("NOT WORN: {}\n", terminal_line(join(certificate.worn_reasons, "; ")));
  if (const auto& unsettled = result.drape.unsettled)
    fmt::print("because {}\nhint: {}\n", terminal_line(unsettled->why),
               terminal_line(unsettled->hint));
  for (const auto& [level, mobility] : result.pattern.fit)
    fmt::print("fit {:8} {:+.3f}\n", terminal_line(level), mobility);
  if (!result.maps.maps.empty())
    fmt::print("{:24} {:>10} {:>10} {:>10}\n", "map", "p5", "median", "p95");
  for (const CaseMap& map : result.maps.maps)
    fmt::print("{:24} {} {} {}\n", map.map.array, number_or_dash(map.overall.p5),
               number_or_dash(map.overall.median), number_or_dash(map.overall.p95));
  if (result.sealed()) fmt::print("sealed: no maps; see log.jsonl, or use --allow-unsettled\n");
  double total = 0;
  std::string stages;
  for (const StageClock::Entry& entry : result.seconds) {
    stages += fmt::format("{} {:.1f}  ", entry.stage, entry.seconds);
    total += entry.seconds;
  }
  fmt::print("seconds: {}total {:.1f}; peak memory {:.0f} MB\n", stages, total,
             result.peak_memory_mb);
  fmt::print("written: {}\n", terminal_line(folder));
}

}  // namespace loosefit

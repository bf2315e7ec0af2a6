#include "planned_files.h"

#include <filesystem>

#include "loosefit/io/scorecard_file.h"
#include "loosefit/report/ranking_output.h"
#include "loosefit/study/case_layers.h"
#include "loosefit/study/wear_states.h"

namespace loosefit {
namespace {

using Path = std::filesystem::path;

/// What render_pictures may draw.
void add_pictures(const ScenarioOutput& output, const Path& folder, const char* through,
                  bool with_maps, std::vector<Path>& files) {
  std::vector<std::string> names;
  if (with_maps) names = output.maps;
  if (output.undecorated) names.push_back("drape");
  if (output.undecorated && through) names.push_back(through);
  for (const std::string& name : names)
    for (const std::string& view : output.views)
      files.push_back(folder / (name + "-" + view + ".png"));
}

}  // namespace

std::vector<std::string> planned_files(const Scenario& scenario, const PlannedWork& work) {
  const int under = static_cast<int>(scenario.worn_under().size());
  const char* const through = under > 0 ? "layers" : nullptr;
  std::vector<Path> files = {"summary.json", "drape.vtp", "body.vtp", "pattern.json",
                             "scenario.toml"};
  if (work.pictures) add_pictures(scenario.output, "maps", through, true, files);
  if (work.log) files.push_back("log.jsonl");
  if (work.sites) files.push_back("sites.csv");
  if (work.report) {
    files.push_back("report.html");
    if (!scenario.ranking.modality.empty())
      for (const std::string& file : ranking_files(load_scorecard(scenario.ranking.modality).name))
        files.emplace_back(file);
  }
  for (int l = 0; l < under; ++l) {
    files.push_back(under_folder(l) / "drape.vtp");
    files.push_back(under_folder(l) / "pattern.json");
    if (work.pictures) add_pictures(scenario.output, under_folder(l), nullptr, true, files);
  }
  const CaseWear wear = plan_wear(scenario);
  for (int d = 0; d < static_cast<int>(wear.donnings.size()); ++d)
    for (int p = d == 0 ? 1 : 0; p < static_cast<int>(wear.postures.size()); ++p) {
      CaseState state;
      state.posture = p, state.donning = d, state.name = wear.postures[p];
      const Path folder = state_folder(state);
      files.push_back(folder / "drape.vtp");
      if (d == 0) files.push_back(folder / "body.vtp");
      for (int l = 0; l < under; ++l) files.push_back(folder / under_folder(l) / "drape.vtp");
      if (work.pictures && d == 0) add_pictures(scenario.output, folder, through, false, files);
    }
  std::vector<std::string> names;
  for (const Path& file : files) names.push_back(file.generic_string());
  return names;
}

}  // namespace loosefit

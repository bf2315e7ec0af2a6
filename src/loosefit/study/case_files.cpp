#include "loosefit/study/case_files.h"

#include "loosefit/io/garmentcode.h"
#include "loosefit/io/text_file.h"
#include "loosefit/io/vtp.h"
#include "loosefit/study/sites_csv.h"
#include "loosefit/study/summary.h"
#include "loosefit/study/wear_states.h"

namespace loosefit {

namespace {

void write_states(const std::filesystem::path& folder, const CaseResult& result) {
  for (const CaseState& state : result.wear.states) {
    if (state.drape.positions.empty()) continue;
    const std::filesystem::path place = folder / state_folder(state);
    std::filesystem::create_directories(place);
    std::vector<PerformanceMap> maps;
    for (const CaseMap& entry : state.maps) maps.push_back(entry.map);
    write_drape_vtp(place / "drape.vtp", result.mesh(), state.drape, maps);
    if (state.donning == 0) write_body_vtp(place / "body.vtp", *result.wear.bodies[state.posture]);
  }
}

}  // namespace

void write_case_files(const std::filesystem::path& folder, const CaseResult& result) {
  std::vector<PerformanceMap> maps;
  for (const CaseMap& entry : result.maps.maps) maps.push_back(entry.map);
  write_drape_vtp(folder / "drape.vtp", result.mesh(), result.drape, maps);
  write_body_vtp(folder / "body.vtp", result.body.body);
  write_states(folder, result);
  write_garmentcode(folder / "pattern.json", result.pattern.pattern);
  write_text_file((folder / "scenario.toml").string(), scenario_toml(result.scenario));
  if (!maps.empty()) write_text_file((folder / "sites.csv").string(), sites_csv(result.sites));
}

void write_summary_file(const std::filesystem::path& folder, const CaseResult& result) {
  write_text_file((folder / "summary.json").string(), summary_json(result));
}

}  // namespace loosefit

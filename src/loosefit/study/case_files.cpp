#include "loosefit/study/case_files.h"

#include "loosefit/io/garmentcode_write.h"
#include "loosefit/io/text_file.h"
#include "loosefit/io/vtp_write.h"
#include "loosefit/study/case_layers.h"
#include "loosefit/study/sites_csv.h"
#include "loosefit/study/summary.h"
#include "loosefit/study/wear_states.h"

namespace loosefit {

namespace {

std::vector<PerformanceMap> plain(const std::vector<CaseMap>& entries) {
  std::vector<PerformanceMap> maps;
  for (const CaseMap& entry : entries) maps.push_back(entry.map);
  return maps;
}

/// Drapes of the garments under the studied one; with their patterns in the folder of the run.
void write_under(const std::filesystem::path& folder, const CaseResult& result,
                 const CaseState* state) {
  for (int l = 0; l < static_cast<int>(result.under.size()); ++l) {
    const CaseUnder& under = result.under[l];
    const std::filesystem::path place = folder / under_folder(l);
    std::filesystem::create_directories(place);
    if (state) {
      write_drape_vtp(place / "drape.vtp", under.mesh(), state->under[l]);
    } else {
      write_drape_vtp(place / "drape.vtp", under.mesh(), under.drape, plain(under.maps.maps));
      write_garmentcode(place / "pattern.json", under.pattern.pattern);
    }
  }
}

void write_states(const std::filesystem::path& folder, const CaseResult& result) {
  for (const CaseState& state : result.wear.states) {
    if (state.drape.positions.empty()) continue;
    const std::filesystem::path place = folder / state_folder(state);
    std::filesystem::create_directories(place);
    write_drape_vtp(place / "drape.vtp", result.mesh(), state.drape, plain(state.maps));
    write_under(place, result, &state);
    if (state.donning == 0) write_body_vtp(place / "body.vtp", *result.wear.bodies[state.posture]);
  }
}

}  // namespace

void write_case_files(const std::filesystem::path& folder, const CaseResult& result) {
  const std::vector<PerformanceMap> maps = plain(result.maps.maps);
  write_drape_vtp(folder / "drape.vtp", result.mesh(), result.drape, maps);
  write_under(folder, result, nullptr);
  write_body_vtp(folder / "body.vtp", result.body.body);
  write_states(folder, result);
  write_garmentcode(folder / "pattern.json", result.pattern.pattern);
  write_text_file((folder / "scenario.toml").string(), scenario_toml(result.scenario));
  if (!maps.empty())
    write_text_file((folder / "sites.csv").string(),
                    sites_csv(result.sites, result.uncovered_sites));
}

void write_summary_file(const std::filesystem::path& folder, const CaseResult& result) {
  write_text_file((folder / "summary.json").string(), summary_json(result));
}

}  // namespace loosefit

#include "loosefit/pipeline/case_files.h"

#include "loosefit/io/garmentcode_write.h"
#include "loosefit/io/pvd_write.h"
#include "loosefit/io/scenario.h"
#include "loosefit/io/scenario_writer.h"
#include "loosefit/io/text_file.h"
#include "loosefit/io/vtp_write.h"
#include "loosefit/pipeline/case_folders.h"
#include "loosefit/pipeline/case_lines.h"
#include "loosefit/pipeline/garment_maps.h"
#include "loosefit/pipeline/sites_csv.h"
#include "loosefit/pipeline/summary.h"

namespace loosefit::pipeline {

namespace {

/// Drapes of the garments under the studied one; with maps and patterns in the folder of the run.
void write_worn_under(const std::filesystem::path& folder, const CaseResult& result,
                      const CaseState* state) {
  for (int g = 0; g < static_cast<int>(result.worn_under().size()); ++g) {
    const CaseGarment& garment = result.garments[g];
    const std::filesystem::path own = folder / under_folder(g);
    std::filesystem::create_directories(own);
    if (state) {
      io::write_drape_vtp(own / "drape.vtp", garment.mesh(), state->drapes[g]);
    } else {
      io::write_drape_vtp(own / "drape.vtp", garment.mesh(), garment.drape,
                          plain_maps(garment.maps.maps), {}, {}, garment.maps.worn.regions);
      io::write_garmentcode(own / "pattern.json", garment.pattern.pattern);
    }
  }
}

void write_states(const std::filesystem::path& folder, const CaseResult& result) {
  // ParaView steps through them in the order of the case.
  std::vector<io::PvdEntry> series = {{"drape.vtp", 0, "reference"}};
  for (const CaseState& state : result.wear.states) {
    if (!state.draped()) continue;
    series.push_back({state_folder(state) / "drape.vtp", static_cast<double>(series.size()),
                      state_folder(state).generic_string()});
    const std::filesystem::path own = folder / state_folder(state);
    std::filesystem::create_directories(own);
    io::write_drape_vtp(own / "drape.vtp", result.studied().mesh(), state.drape(),
                        plain_maps(state.maps.maps), {}, {}, state.maps.worn.regions);
    write_worn_under(own, result, &state);
    if (state.id.in_first_donning())
      io::write_body_vtp(own / "body.vtp", result.body_in(state.id.posture));
  }
  if (!result.wear.states.empty()) io::write_pvd(folder / kSeriesFile, series);
}

}  // namespace

void write_case_files(const std::filesystem::path& folder, const CaseResult& result) {
  const CaseGarment& studied = result.studied();
  const std::vector<maps::PerformanceMap> maps = plain_maps(studied.maps.maps);
  io::write_drape_vtp(folder / "drape.vtp", studied.mesh(), studied.drape, maps, {}, {},
                      studied.maps.worn.regions);
  write_worn_under(folder, result, nullptr);
  io::write_body_vtp(folder / "body.vtp", result.body.body);
  write_states(folder, result);
  io::write_garmentcode(folder / "pattern.json", studied.pattern.pattern);
  io::write_text_file((folder / "scenario.toml").string(), io::scenario_toml(result.scenario));
  if (!maps.empty())
    io::write_text_file((folder / "sites.csv").string(),
                        sites_csv(result.sites, result.scenario.simulation.edge_length,
                                  result.uncovered_sites, result.lines));
  if (!result.lines.empty())
    io::write_text_file((folder / "lines.csv").string(), lines_csv(result));
}

void write_summary_file(const std::filesystem::path& folder, const CaseResult& result) {
  io::write_text_file((folder / "summary.json").string(), summary_json(result));
}

}  // namespace loosefit::pipeline

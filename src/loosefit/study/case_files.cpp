#include "loosefit/study/case_files.h"

#include "loosefit/io/garmentcode.h"
#include "loosefit/io/text_file.h"
#include "loosefit/io/vtp.h"
#include "loosefit/study/sites_csv.h"
#include "loosefit/study/summary.h"

namespace loosefit {

void write_case_files(const std::filesystem::path& folder, const CaseResult& result) {
  std::vector<PerformanceMap> maps;
  for (const CaseMap& entry : result.maps.maps) maps.push_back(entry.map);
  write_drape_vtp(folder / "drape.vtp", result.mesh(), result.drape, maps);
  write_body_vtp(folder / "body.vtp", result.body.body);
  write_garmentcode(folder / "pattern.json", result.pattern.pattern);
  write_text_file((folder / "scenario.toml").string(), scenario_toml(result.scenario));
  if (!maps.empty()) write_text_file((folder / "sites.csv").string(), sites_csv(result.sites));
}

void write_summary_file(const std::filesystem::path& folder, const CaseResult& result) {
  write_text_file((folder / "summary.json").string(), summary_json(result));
}

}  // namespace loosefit

#include "loosefit/study/load_case.h"

#include <nlohmann/json.hpp>

#include "loosefit/base/error.h"
#include "loosefit/io/text_file.h"
#include "loosefit/io/vtp.h"

namespace loosefit {
namespace {

double seconds_in_summary(const std::filesystem::path& file, const std::string& stage) {
  const auto summary =
      nlohmann::json::parse(read_text_file(file.string(), 50000000), nullptr, false);
  const auto place = nlohmann::json::json_pointer("/seconds/" + stage);
  if (summary.is_discarded() || !summary.contains(place) || !summary[place].is_number()) return 0;
  return summary[place].get<double>();
}

}  // namespace

CaseResult load_case(const std::filesystem::path& folder, Progress& progress) {
  StageClock clock(progress);
  CaseResult result;
  result.scenario = read_scenario((folder / "scenario.toml").string());
  clock.stage("body");
  result.body = make_body(result.scenario.body);
  clock.stage("pattern");
  result.pattern = make_pattern(result.scenario.garment, result.body.body);
  clock.stage("garment");
  result.garment = build_hierarchy(result.pattern.pattern, result.scenario.simulation.edge_length,
                                   result.scenario.material.material, result.scenario.attachments);
  clock.stop();
  DrapeFile file = read_drape_vtp(folder / "drape.vtp");
  if (file.garment.triangles != result.mesh().triangles)
    throw InvalidInput({(folder / "drape.vtp").string(), 0, ""}, "another garment",
                       "the mesh that scenario.toml beside it makes",
                       "make the drape again: loosefit run scenario.toml -o DIR");
  result.drape = std::move(file.drape);
  result.seconds = clock.entries();
  for (const char* stage : {"dress", "settle"})
    result.seconds.push_back({stage, seconds_in_summary(folder / "summary.json", stage)});
  return result;
}

}  // namespace loosefit

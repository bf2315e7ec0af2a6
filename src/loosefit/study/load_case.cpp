#include "loosefit/study/load_case.h"

#include <nlohmann/json.hpp>

#include "loosefit/base/error.h"
#include "loosefit/io/text_file.h"
#include "loosefit/io/vtp.h"
#include "loosefit/study/case_boards.h"

namespace loosefit {
namespace {

using Json = nlohmann::json;

/// Number at a place of summary.json; 0 where there is none.
template <class Number>
Number at(const Json& summary, const std::string& place) {
  const Json::json_pointer pointer(place);
  return summary.contains(pointer) && summary[pointer].is_number() ? summary[pointer].get<Number>()
                                                                   : Number{0};
}

void recall_parts(const Json& summary, SettleReport& report) {
  const Json::json_pointer place("/settle/parts");
  if (!summary.contains(place) || !summary[place].is_array()) return;
  for (const Json& part : summary[place]) {
    SolverWork work;
    work.iterations = at<int>(part, "/iterations");
    work.factorisations = at<int>(part, "/factorisations");
    work.assemble = at<double>(part, "/seconds/assemble");
    work.factorise = at<double>(part, "/seconds/factorise");
    work.solve = at<double>(part, "/seconds/solve");
    work.collide = at<double>(part, "/seconds/collide");
    work.evaluate = at<double>(part, "/seconds/evaluate");
    work.refresh = at<double>(part, "/seconds/refresh");
    report.parts.push_back(
        {part.contains("part") && part["part"].is_string() ? part["part"].get<std::string>() : "",
         at<int>(part, "/level") - 1, at<int>(part, "/vertices"), work});
  }
}

/// What was counted and timed when the drape was made.
void recall(const Json& summary, CaseResult& result) {
  for (const char* stage : {"dress", "settle"})
    result.seconds.push_back({stage, at<double>(summary, std::string("/seconds/") + stage)});
  SettleReport& report = result.drape.report;
  recall_parts(summary, report);
  report.ccd_queries = at<int>(summary, "/settle/ccd_queries");
  report.contacts_body = at<int>(summary, "/settle/contacts_body");
  report.contacts_self = at<int>(summary, "/settle/contacts_self");
  report.held_off_triangles = at<int>(summary, "/settle/held_off_triangles");
  report.largest_contact_offset = 1e-3 * at<double>(summary, "/settle/largest_contact_offset_mm");
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
  result.garment =
      build_hierarchy(result.pattern.pattern, result.scenario.simulation.edge_length,
                      result.scenario.material.material, all_attachments(result.scenario));
  clock.stop();
  DrapeFile file = read_drape_vtp(folder / "drape.vtp");
  if (file.garment.triangles != result.mesh().triangles)
    throw InvalidInput({(folder / "drape.vtp").string(), 0, ""}, "another garment",
                       "the mesh that scenario.toml beside it makes with this version",
                       "make the drape again: loosefit run scenario.toml -o DIR");
  result.drape = std::move(file.drape);
  result.seconds = clock.entries();
  const std::string text = read_text_file((folder / "summary.json").string(), 50000000);
  recall(Json::parse(text, nullptr, false), result);
  return result;
}

}  // namespace loosefit

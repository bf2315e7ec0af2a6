#include "loosefit/study/load_case.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "loosefit/base/error.h"
#include "loosefit/io/text_file.h"
#include "loosefit/io/vtp.h"
#include "loosefit/study/case_boards.h"
#include "loosefit/study/case_layers.h"
#include "loosefit/study/wear_states.h"

namespace loosefit {
namespace {

using Json = nlohmann::json;

constexpr double kSameSkin = 1e-5;  ///< round-off of another processor, less than a map shows [m]

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
    work.regional = at<int>(part, "/regional_iterations");
    work.region = at<double>(part, "/seconds/region");
    report.parts.push_back(
        {part.contains("part") && part["part"].is_string() ? part["part"].get<std::string>() : "",
         at<int>(part, "/level") - 1, at<int>(part, "/vertices"), work});
  }
}

/// What was counted and timed when the drape was made.
void recall(const Json& summary, CaseResult& result) {
  for (const char* stage : {"dress", "settle", "postures", "donnings", "repeats"})
    if (const std::string place = std::string("/seconds/") + stage;
        summary.contains(Json::json_pointer(place)))
      result.seconds.push_back({stage, at<double>(summary, place)});
  if (summary.contains("repeats") && summary["repeats"].is_object())
    for (const auto& [key, spread] : summary["repeats"].items())
      result.repeats[key] = {at<double>(spread, "/mean"), at<double>(spread, "/deviation"),
                             at<int>(spread, "/count")};
  SettleReport& report = result.drape.report;
  recall_parts(summary, report);
  report.ccd_queries = at<int>(summary, "/settle/ccd_queries");
  report.contacts_body = at<int>(summary, "/settle/contacts_body");
  report.contacts_self = at<int>(summary, "/settle/contacts_self");
  report.held_off_triangles = at<int>(summary, "/settle/held_off_triangles");
  report.largest_contact_offset = 1e-3 * at<double>(summary, "/settle/largest_contact_offset_mm");
}

/// The drape of a file, if it is of this garment.
Drape read_drape(const std::filesystem::path& path, const Garment& garment) {
  DrapeFile file = read_drape_vtp(path);
  if (file.garment.triangles != garment.triangles)
    throw InvalidInput({path.string(), 0, ""}, "another garment",
                       "the mesh that scenario.toml of the run makes with this version",
                       "make the drape again: loosefit run scenario.toml -o DIR");
  return std::move(file.drape);
}

/// A drape lies on the body that it was made with: its certificate and every distance hold for that
/// one alone.
void check_body(const std::filesystem::path& path, const Body& body) {
  const TriangleMesh drawn = read_body_vtp(path);
  double farthest = 0;
  if (drawn.triangles == body.surface.triangles)
    for (std::size_t i = 0; i < drawn.vertices.size(); ++i)
      farthest = std::max(farthest, (drawn.vertices[i] - body.surface.vertices[i]).norm());
  else
    farthest = std::numeric_limits<double>::infinity();
  if (farthest <= kSameSkin) return;
  throw InvalidInput({path.string(), 0, ""},
                     std::isfinite(farthest)
                         ? fmt::format("a body whose skin lies up to {:.2g} mm off", 1e3 * farthest)
                         : "another body",
                     "the body that scenario.toml of the run makes with this version",
                     "make the drape again: loosefit run scenario.toml -o DIR");
}

/// Postures and donnings; none were made when the first drape is not settled.
void recall_wear(const std::filesystem::path& folder, const Json& summary, CaseResult& result,
                 Progress& progress) {
  result.wear = plan_wear(result.scenario);
  if (!result.drape.certificate.settled()) return;
  pose_wearers(result.body, result.wear, progress);
  const CaseWear& wear = result.wear;
  int index = 0;
  for (int d = 0; d < static_cast<int>(wear.donnings.size()); ++d)
    for (int p = d == 0 ? 1 : 0; p < static_cast<int>(wear.postures.size()); ++p, ++index) {
      CaseState state;
      state.posture = p, state.donning = d, state.name = wear.postures[p];
      state.seconds = at<double>(summary, "/states/" + std::to_string(index) + "/seconds");
      const std::filesystem::path file = folder / state_folder(state) / "drape.vtp";
      std::error_code error;
      if (std::filesystem::exists(file, error)) {
        if (d == 0) check_body(file.parent_path() / "body.vtp", *wear.bodies[p]);
        state.drape = read_drape(file, result.mesh());
        for (int l = 0; l < static_cast<int>(result.under.size()); ++l)
          state.under.push_back(read_drape(file.parent_path() / under_folder(l) / "drape.vtp",
                                           result.under[l].mesh()));
        check_worn(result, state);
      } else {
        state.left_out = "the run has no drape of it";
      }
      result.wear.states.push_back(std::move(state));
    }
}

}  // namespace

CaseResult load_case(const std::filesystem::path& folder, Progress& progress) {
  StageClock clock(progress);
  CaseResult result;
  result.scenario = read_scenario((folder / "scenario.toml").string());
  clock.stage("body");
  result.body = make_body(result.scenario.body);
  clock.stage("pattern");
  result.under = make_under_patterns(result.scenario, result.body.body);
  result.pattern = make_pattern(result.scenario.garment, result.body.body);
  clock.stage("garment");
  result.garment =
      build_hierarchy(result.pattern.pattern, result.scenario.simulation.edge_length,
                      result.scenario.material.material, all_attachments(result.scenario));
  mesh_under(result, result.scenario.simulation.edge_length);
  clock.stop();
  check_body(folder / "body.vtp", result.body.body);
  result.drape = read_drape(folder / "drape.vtp", result.mesh());
  for (int l = 0; l < static_cast<int>(result.under.size()); ++l)
    result.under[l].drape =
        read_drape(folder / under_folder(l) / "drape.vtp", result.under[l].mesh());
  result.seconds = clock.entries();
  const std::string text = read_text_file((folder / "summary.json").string(), 50000000);
  const Json summary = Json::parse(text, nullptr, false);
  recall(summary, result);
  recall_wear(folder, summary, result, progress);
  return result;
}

}  // namespace loosefit

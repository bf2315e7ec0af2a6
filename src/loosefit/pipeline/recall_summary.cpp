#include "loosefit/pipeline/recall_summary.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "loosefit/base/error.h"
#include "loosefit/base/sha256.h"
#include "loosefit/base/text.h"
#include "loosefit/drape/recoveries.h"
#include "loosefit/io/scenario.h"
#include "loosefit/io/scenario_writer.h"
#include "loosefit/io/text_file.h"

namespace loosefit::pipeline {
namespace {

using Json = nlohmann::json;

/// Number at a place of summary.json; 0 where there is none.
template <class Number>
Number at(const Json& summary, const std::string& place) {
  const Json::json_pointer pointer(place);
  return summary.contains(pointer) && summary[pointer].is_number() ? summary[pointer].get<Number>()
                                                                   : Number{0};
}

std::vector<drape::PartWork> parts_in(const Json& summary) {
  std::vector<drape::PartWork> parts;
  const Json::json_pointer place("/settle/parts");
  if (!summary.contains(place) || !summary[place].is_array()) return parts;
  for (const Json& part : summary[place]) {
    solver::SolverWork work;
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
    parts.push_back(
        {part.contains("part") && part["part"].is_string() ? part["part"].get<std::string>() : "",
         at<int>(part, "/level") - 1, at<int>(part, "/vertices"), work});
  }
  return parts;
}

/// Recoveries that this program knows; what others were called elsewhere is left out.
std::vector<drape::RecoveryCount> recoveries_in(const Json& summary) {
  std::vector<drape::RecoveryCount> counts;
  const Json::json_pointer place("/settle/recoveries");
  if (!summary.contains(place) || !summary[place].is_array()) return counts;
  for (const Json& entry : summary[place])
    for (const drape::Recovery& known : drape::recoveries())
      if (entry.is_object() && entry.value("name", Json()) == known.name)
        counts.push_back({known.kind, known.name, at<int>(entry, "/times")});
  return counts;
}

std::vector<CaseMovement> movements_in(const Json& summary) {
  std::vector<CaseMovement> movements;
  const Json::json_pointer place("/settle/movements");
  if (!summary.contains(place) || !summary[place].is_array()) return movements;
  for (const Json& entry : summary[place])
    if (entry.is_object() && entry.contains("name") && entry["name"].is_string())
      movements.push_back({entry["name"].get<std::string>(), at<double>(entry, "/size")});
  return movements;
}

/// A spread over drapes from other starts.
Spread spread_at(const std::string& file, const std::string& key, const Json& entry) {
  const auto number = [&](const char* name) {
    if (entry.is_object() && entry.contains(name) && entry[name].is_number())
      return entry[name].get<double>();
    throw InvalidInput({file, 0, "repeats." + key},
                       printable(entry.dump(-1, ' ', false, Json::error_handler_t::replace), 60),
                       "mean, deviation and count as numbers", kMakeAgain);
  };
  const Spread spread{number("mean"), number("deviation"),
                      static_cast<int>(std::clamp(number("count"), 0.0, 1e6))};
  if (spread.count < 2)
    throw InvalidInput({file, 0, "repeats." + key + ".count"}, std::to_string(spread.count),
                       "two drapes or more", kMakeAgain);
  return spread;
}

CaseRepeats repeats_in(const std::string& file, const Json& summary,
                       const scenario::Scenario& scenario) {
  CaseRepeats repeats;
  if (scenario.simulation.repeats < 2) return repeats;
  // Spreads hold for the sites and the garment that the scenario had then.
  if (!summary.contains("scenario_sha256") ||
      summary["scenario_sha256"] != sha256_hex(io::scenario_toml(scenario))) {
    repeats.warnings.push_back(
        "scenario.toml has been changed since the drapes from other starts: their spread is left "
        "out");
    return repeats;
  }
  if (summary.contains("repeats")) {
    const Json& all = summary["repeats"];
    if (!all.is_object())
      throw InvalidInput({file, 0, "repeats"}, all.type_name(), "a table of spreads", kMakeAgain);
    for (const auto& [key, entry] : all.items()) repeats.spread[key] = spread_at(file, key, entry);
  }
  if (summary.contains("repeat_warnings") && summary["repeat_warnings"].is_array())
    for (const Json& text : summary["repeat_warnings"])
      if (text.is_string()) repeats.warnings.push_back(text.get<std::string>());
  return repeats;
}

std::vector<StageClock::Entry> draping_seconds(const Json& summary) {
  std::vector<StageClock::Entry> seconds;
  for (const char* stage : {"dress", "settle", "postures", "donnings", "repeats"})
    if (const std::string place = std::string("/seconds/") + stage;
        summary.contains(Json::json_pointer(place)))
      seconds.push_back({stage, at<double>(summary, place)});
  return seconds;
}

drape::SettleReport report_in(const Json& summary) {
  drape::SettleReport report;
  report.parts = parts_in(summary);
  report.recoveries = recoveries_in(summary);
  report.ccd_queries = at<int>(summary, "/settle/ccd_queries");
  report.contacts_body = at<int>(summary, "/settle/contacts_body");
  report.contacts_self = at<int>(summary, "/settle/contacts_self");
  report.held_off_triangles = at<int>(summary, "/settle/held_off_triangles");
  report.largest_contact_offset = 1e-3 * at<double>(summary, "/settle/largest_contact_offset_mm");
  report.bearing_area = at<double>(summary, "/settle/bearing_area_m2");
  if (report.bearing_area > 0)
    report.bearing_distance = 1e-3 * at<double>(summary, "/settle/bearing_distance_mm");
  return report;
}

}  // namespace

RecalledSummary recall_summary(const std::filesystem::path& folder, const CaseResult& loaded) {
  const std::string file = (folder / "summary.json").string();
  const Json summary = Json::parse(io::read_text_file(file, 50000000), nullptr, false);
  if (!summary.is_object())
    throw InvalidInput({file, 0, ""}, summary.is_discarded() ? "no JSON" : summary.type_name(),
                       "a summary.json as loosefit wrote it", kMakeAgain);
  RecalledSummary recalled;
  recalled.seconds = draping_seconds(summary);
  recalled.report = report_in(summary);
  recalled.movements = movements_in(summary);
  recalled.repeats = repeats_in(file, summary, loaded.scenario);
  for (std::size_t k = 0; k < loaded.wear.states.size(); ++k)
    recalled.state_seconds.push_back(
        at<double>(summary, "/states/" + std::to_string(k) + "/seconds"));
  return recalled;
}

}  // namespace loosefit::pipeline

#include "loosefit/pipeline/recall_summary.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "loosefit/base/error.h"
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

/// Objects of the list at a place of summary.json; none where there is no list. What is no object
/// is left out.
std::vector<Json> objects_at(const Json& summary, const std::string& place) {
  const Json::json_pointer pointer(place);
  std::vector<Json> objects;
  if (!summary.contains(pointer) || !summary[pointer].is_array()) return objects;
  for (const Json& entry : summary[pointer])
    if (entry.is_object()) objects.push_back(entry);
  return objects;
}

/// Text at a key of an object; empty where there is none.
std::string text_at(const Json& object, const std::string& key) {
  return object.contains(key) && object[key].is_string() ? object[key].get<std::string>() : "";
}

/// Texts of the list at a place of summary.json.
std::vector<std::string> texts_at(const Json& summary, const std::string& place) {
  const Json::json_pointer pointer(place);
  std::vector<std::string> texts;
  if (!summary.contains(pointer) || !summary[pointer].is_array()) return texts;
  for (const Json& entry : summary[pointer])
    if (entry.is_string()) texts.push_back(entry.get<std::string>());
  return texts;
}

std::vector<drape::PartWork> parts_at(const Json& summary, const std::string& place) {
  std::vector<drape::PartWork> parts;
  for (const Json& part : objects_at(summary, place)) {
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
    parts.push_back({text_at(part, "part"), at<int>(part, "/level") - 1, at<int>(part, "/vertices"),
                     std::max(at<int>(part, "/start"), 1) - 1, work});
  }
  return parts;
}

/// Place and panel of a vertex or triangle that speaks against a drape.
template <class Place>
Place place_in(const Json& entry) {
  Place place;
  place.panel = text_at(entry, "panel");
  place.at = Vec2(at<double>(entry, "/u_m"), at<double>(entry, "/v_m"));
  for (int k = 0; k < 3; ++k)
    place.position[k] = at<double>(entry, "/position_m/" + std::to_string(k));
  return place;
}

std::optional<drape::Unsettled> unsettled_at(const Json& summary, const std::string& place) {
  const Json::json_pointer pointer(place);
  if (!summary.contains(pointer) || !summary[pointer].is_object()) return {};
  const Json& json = summary[pointer];
  drape::Unsettled unsettled;
  unsettled.why = text_at(json, "why");
  unsettled.hint = text_at(json, "hint");
  unsettled.times_allowed = at<double>(json, "/times_allowed");
  unsettled.vertices_of_most = at<int>(json, "/vertices_of_90_percent");
  unsettled.lagging_share = at<double>(json, "/lagging_friction_share");
  for (const Json& entry : objects_at(json, "/worst")) {
    auto vertex = place_in<drape::UnbalancedVertex>(entry);
    vertex.vertex = at<int>(entry, "/vertex");
    vertex.near = text_at(entry, "near");
    vertex.net = at<double>(entry, "/net_N");
    for (std::size_t k = 0; k < vertex.force.size(); ++k)
      vertex.force[k] = at<double>(entry, std::string("/force_N/") + drape::kForceNames[k]);
    unsettled.worst.push_back(std::move(vertex));
  }
  for (const Json& entry : objects_at(json, "/cuts")) {
    auto cut = place_in<drape::CutTriangle>(entry);
    cut.triangle = at<int>(entry, "/triangle");
    cut.body = text_at(entry, "cuts") == "body";
    cut.with = text_at(entry, "with");
    unsettled.cuts.push_back(std::move(cut));
  }
  return unsettled;
}

/// Recoveries that this program knows; what others were called elsewhere is left out.
std::vector<drape::RecoveryCount> recoveries_in(const Json& summary) {
  std::vector<drape::RecoveryCount> counts;
  for (const Json& entry : objects_at(summary, "/settle/recoveries"))
    for (const drape::Recovery& known : drape::recoveries())
      if (text_at(entry, "name") == known.name)
        counts.push_back({known.kind, known.name, at<int>(entry, "/times")});
  return counts;
}

std::vector<CaseMovement> movements_in(const Json& summary) {
  std::vector<CaseMovement> movements;
  for (const Json& entry : objects_at(summary, "/settle/movements"))
    if (const std::string name = text_at(entry, "name"); !name.empty())
      movements.push_back({name, at<double>(entry, "/size")});
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
  if (!io::is_digest_of(text_at(summary, "scenario_sha256"), io::scenario_toml(scenario))) {
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
  for (std::string& text : texts_at(summary, "/repeat_warnings"))
    repeats.warnings.push_back(std::move(text));
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
  report.parts = parts_at(summary, "/settle/parts");
  report.recoveries = recoveries_in(summary);
  report.ccd_queries = at<int>(summary, "/settle/ccd_queries");
  report.contacts_body = at<int>(summary, "/settle/contacts_body");
  report.contacts_self = at<int>(summary, "/settle/contacts_self");
  report.held_off_triangles = at<int>(summary, "/settle/held_off_triangles");
  report.largest_contact_offset = 1e-3 * at<double>(summary, "/settle/largest_contact_offset_mm");
  report.coarsened_field = 1e-3 * at<double>(summary, "/settle/coarsened_field_mm");
  report.floor_force = at<double>(summary, "/settle/floor_force_N");
  report.bearing_area = at<double>(summary, "/settle/bearing_area_m2");
  if (report.bearing_area > 0)
    report.bearing_distance = 1e-3 * at<double>(summary, "/settle/bearing_distance_mm");
  return report;
}

RecalledState state_in(const Json& summary, const std::string& place) {
  const Json::json_pointer pointer(place);
  if (!summary.contains(pointer) || !summary[pointer].is_object()) return {};
  const Json& state = summary[pointer];
  const bool had_none = state.contains("worn") && state["worn"].is_null();
  drape::SettleReport report;
  report.parts = parts_at(state, "/parts");
  report.held_off_triangles = at<int>(state, "/held_off_triangles");
  report.largest_contact_offset = 1e-3 * at<double>(state, "/largest_contact_offset_mm");
  report.coarsened_field = 1e-3 * at<double>(state, "/coarsened_field_mm");
  return {at<double>(state, "/seconds"), std::move(report), unsettled_at(state, "/unsettled"),
          had_none ? text_at(state, "stop_reason") : ""};
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
  if (summary.contains("draped_from") && summary["draped_from"].is_object())
    for (const auto& entry : summary["draped_from"].items())
      recalled.draped_from[entry.key()] = text_at(summary["draped_from"], entry.key());
  recalled.movements = movements_in(summary);
  recalled.repeats = repeats_in(file, summary, loaded.scenario);
  recalled.unsettled = unsettled_at(summary, "/settle/unsettled");
  recalled.dressing_warnings = texts_at(summary, "/settle/warnings");
  for (std::size_t k = 0; k < loaded.wear.states.size(); ++k)
    recalled.states.push_back(state_in(summary, "/states/" + std::to_string(k)));
  recalled.donning_warnings = texts_at(summary, "/donning_warnings");
  return recalled;
}

}  // namespace loosefit::pipeline

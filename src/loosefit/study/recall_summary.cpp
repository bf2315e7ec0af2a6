#include "loosefit/study/recall_summary.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "loosefit/base/error.h"
#include "loosefit/base/sha256.h"
#include "loosefit/base/text.h"
#include "loosefit/io/scenario.h"
#include "loosefit/io/text_file.h"

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
    work.regional = at<int>(part, "/regional_iterations");
    work.region = at<double>(part, "/seconds/region");
    report.parts.push_back(
        {part.contains("part") && part["part"].is_string() ? part["part"].get<std::string>() : "",
         at<int>(part, "/level") - 1, at<int>(part, "/vertices"), work});
  }
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

void recall_repeats(const std::string& file, const Json& summary, CaseResult& result) {
  if (result.scenario.simulation.repeats < 2) return;
  // Spreads hold for the sites and the garment that the scenario had then.
  if (!summary.contains("scenario_sha256") ||
      summary["scenario_sha256"] != sha256_hex(scenario_toml(result.scenario))) {
    result.repeat_warnings.push_back(
        "scenario.toml has been changed since the drapes from other starts: their spread is left "
        "out");
    return;
  }
  if (summary.contains("repeats")) {
    const Json& all = summary["repeats"];
    if (!all.is_object())
      throw InvalidInput({file, 0, "repeats"}, all.type_name(), "a table of spreads", kMakeAgain);
    for (const auto& [key, entry] : all.items()) result.repeats[key] = spread_at(file, key, entry);
  }
  if (summary.contains("repeat_warnings") && summary["repeat_warnings"].is_array())
    for (const Json& text : summary["repeat_warnings"])
      if (text.is_string()) result.repeat_warnings.push_back(text.get<std::string>());
}

/// What was counted and timed when the drape was made.
void recall(const std::string& file, const Json& summary, CaseResult& result) {
  for (const char* stage : {"dress", "settle", "postures", "donnings", "repeats"})
    if (const std::string place = std::string("/seconds/") + stage;
        summary.contains(Json::json_pointer(place)))
      result.seconds.push_back({stage, at<double>(summary, place)});
  recall_repeats(file, summary, result);
  SettleReport& report = result.drape.report;
  recall_parts(summary, report);
  report.ccd_queries = at<int>(summary, "/settle/ccd_queries");
  report.contacts_body = at<int>(summary, "/settle/contacts_body");
  report.contacts_self = at<int>(summary, "/settle/contacts_self");
  report.held_off_triangles = at<int>(summary, "/settle/held_off_triangles");
  report.largest_contact_offset = 1e-3 * at<double>(summary, "/settle/largest_contact_offset_mm");
}

}  // namespace

void recall_summary(const std::filesystem::path& folder, CaseResult& result) {
  const std::string file = (folder / "summary.json").string();
  const Json summary = Json::parse(read_text_file(file, 50000000), nullptr, false);
  if (!summary.is_object())
    throw InvalidInput({file, 0, ""}, summary.is_discarded() ? "no JSON" : summary.type_name(),
                       "a summary.json as loosefit wrote it", kMakeAgain);
  recall(file, summary, result);
  for (std::size_t k = 0; k < result.wear.states.size(); ++k)
    result.wear.states[k].seconds =
        at<double>(summary, "/states/" + std::to_string(k) + "/seconds");
}

}  // namespace loosefit

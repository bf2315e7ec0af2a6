#include "loosefit/study/analysis_json.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "loosefit/base/control_characters.h"
#include "loosefit/base/version.h"
#include "loosefit/placement/metric_names.h"
#include "loosefit/study/cautions.h"
#include "loosefit/study/unit_words.h"

namespace loosefit::study {
namespace {

using Json = nlohmann::json;

/// Infinities are words: limits that were not reached.
Json number(double value) {
  if (std::isnan(value)) return nullptr;
  if (std::isinf(value)) return value > 0 ? "beyond the loosest" : "nowhere";
  return value;
}

Json bounds(const Bounds& b) { return {number(b.low), number(b.high)}; }

Json ranking_json(const std::vector<SitePopulation>& ranking) {
  Json rows = Json::array();
  for (const SitePopulation& s : ranking)
    rows.push_back({{"site", s.site},
                    {"rank", s.rank > 0 ? Json(s.rank) : Json(nullptr)},
                    {"rank_interval", bounds(s.rank_interval)},
                    {"best_probability", number(s.first)},
                    {"rated", s.rated},
                    {"people", s.people},
                    {"median", number(s.median)},
                    {"median_interval", bounds(s.median_interval)},
                    {"p5", number(s.p5)},
                    {"p5_interval", bounds(s.robust_interval)},
                    {"p95", number(s.p95)},
                    {"passing", number(s.passing)},
                    {"tied_with", s.tied_with}});
  return rows;
}

/// `left_out`: people without a value; `cases_left_out`: cases of all people.
Json metrics_json(const std::vector<MetricPercentiles>& metrics) {
  Json rows = Json::array();
  for (const MetricPercentiles& m : metrics) {
    const placement::MetricName* name = placement::find_metric(m.metric);
    rows.push_back({{"site", m.site},
                    {"metric", m.metric},
                    {"words", name ? name->words : m.metric},
                    {"unit", name ? name->unit : ""},
                    {"n", m.known},
                    {"left_out", m.people - m.known},
                    {"cases_left_out", m.cases - m.known_cases},
                    {"median", number(m.median)},
                    {"median_interval", bounds(m.median_interval)},
                    {"p5", number(m.p5)},
                    {"p5_interval", bounds(m.p5_interval)},
                    {"p95", number(m.p95)},
                    {"p95_interval", bounds(m.p95_interval)}});
  }
  return rows;
}

Json how_loose_json(const HowLoose& answer) {
  Json curve = Json::array();
  for (const LoosePoint& p : answer.curve)
    curve.push_back({{"bgm", number(p.bgm)},
                     {"rated", p.rated},
                     {"robust", number(p.robust)},
                     {"robust_interval", bounds(p.robust_interval)},
                     {"median", number(p.median)},
                     {"passing", number(p.passing)}});
  const Json limit = answer.at_most > answer.limit
                         ? Json(limit_text({answer.limit, answer.at_most},
                                           {answer.curve.front().bgm, answer.curve.back().bgm}))
                         : number(answer.limit);
  return {{"limit_bgm", limit},
          {"interval", bounds(answer.interval)},
          {"fails_below_bgm", std::isinf(answer.tightest) ? Json(nullptr) : Json(answer.tightest)},
          {"curve", curve}};
}

Json modality_json(const ModalityAnalysis& modality, const StudyData& data) {
  Json json = {{"title", modality.title},       {"pass", modality.pass},
               {"not_told", modality.untold},   {"not_told_in_part", modality.untold_in_part},
               {"rankings", Json::array()},     {"how_loose", Json::object()},
               {"sensors", Json::array()},      {"sensitivity", Json::array()},
               {"limiting", modality.limiting}, {"metric_percentiles", Json::array()}};
  const auto at_level = [&](std::size_t k, const char* key, Json rows) {
    return Json{{"level", k < data.level_labels.size() ? data.level_labels[k] : "all"},
                {"bgm", k < data.level_bgm.size() ? number(data.level_bgm[k]) : Json(nullptr)},
                {key, std::move(rows)}};
  };
  for (std::size_t k = 0; k < modality.rankings.size(); ++k)
    json["rankings"].push_back(at_level(k, "sites", ranking_json(modality.rankings[k])));
  for (std::size_t k = 0; k < modality.metrics.size(); ++k)
    json["metric_percentiles"].push_back(at_level(k, "metrics", metrics_json(modality.metrics[k])));
  for (const auto& [site, answer] : modality.how_loose)
    json["how_loose"][site] = how_loose_json(answer);
  for (const SensorChoice& choice : modality.sensors)
    json["sensors"].push_back(
        {{"site", choice.site}, {"mean", choice.mean}, {"robust", choice.robust}});
  for (const Sensitivity& s : modality.sensitivity)
    json["sensitivity"].push_back({{"site", s.site},
                                   {"quantity", s.quantity},
                                   {"input", s.input},
                                   {"kind", s.main_effect ? "main effect" : "rank correlation"},
                                   {"units", s.units},
                                   {"value", number(s.value)},
                                   {"interval", bounds(s.interval)}});
  return json;
}

}  // namespace

std::string analysis_json(const StudyAnalysis& analysis) {
  const StudyData& data = analysis.data;
  Json json = {
      {"study", data.plan.name},
      {"version", version()},
      {"plan_sha256", plan_sha256(data.plan)},
      {"cases", data.plan.cases.size()},
      {"done", data.done},
      {"scored", data.scored},
      {"people", people_axis(data.plan) >= 0 ? Json(data.units.size()) : Json(nullptr)},
      {"units", name(unit_kind(data))},
      {"unit_count", data.units.size()},
      {"drapes", data.drapes},
      {"drapes_counted", data.drapes_counted},
      {"confidence", analysis.options.confidence},
      {"rated", rated_units(data)},
      {"worst_is_below_p5_with_confidence",
       !is_sample(data) ? Json(nullptr)
                        : Json(worst_of_n_confidence(rated_units(data), 1 - kRobustPeople))},
      {"headlines", headlines(analysis)},
      {"warned", warned_cases(data)},
      {"cautions", Json::array()},
      {"modalities", Json::object()},
      {"troubles", Json::array()}};
  for (const Caution& caution : group_warnings(data))
    json["cautions"].push_back(
        {{"example", caution.example}, {"number", caution.number}, {"cases", caution.cases}});
  if (analysis.comfort) {
    Json shares = Json::array();
    for (const double share : analysis.comfort->worst_share)
      shares.push_back(std::isfinite(share) ? Json(share) : Json(nullptr));
    const double limit = analysis.comfort->limit;
    json["comfort"] = {
        {"limit_bgm",
         std::isinf(limit) ? Json(limit < 0 ? "at the tightest" : "nowhere") : number(limit)},
        {"uncomfortable_share_p95", shares}};
  }
  for (const ModalityAnalysis& modality : analysis.modalities)
    json["modalities"][modality.name] = modality_json(modality, data);
  for (const CaseTrouble& t : data.troubles)
    json["troubles"].push_back(
        {{"number", t.number}, {"case", t.label}, {"status", t.status}, {"reason", t.reason}});
  return json_without_controls(json.dump(1, ' ', false, Json::error_handler_t::replace)) + "\n";
}

}  // namespace loosefit::study

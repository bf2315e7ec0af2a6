#include "loosefit/report/ranking_output.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "loosefit/base/control_characters.h"
#include "loosefit/base/quantile.h"
#include "loosefit/base/text.h"
#include "loosefit/io/address_columns.h"
#include "loosefit/io/csv.h"
#include "loosefit/io/text_file.h"
#include "loosefit/pipeline/pattern_marks.h"
#include "loosefit/pipeline/site_values.h"
#include "loosefit/placement/derived_metrics.h"
#include "loosefit/report/sewing_plan.h"
#include "loosefit/report/write_lines.h"

namespace loosefit::report {
namespace {

using Json = nlohmann::ordered_json;

/// Values of every metric of one site over its samples; NaN where a sample lacks one.
std::map<std::string, std::vector<double>> by_metric(const placement::RankingTable& table,
                                                     int index) {
  const placement::SiteSamples& site = table.sites[index];
  std::map<std::string, std::vector<double>> values;
  for (std::size_t k = 0; k < site.samples.size(); ++k)
    for (const auto& [name, value] : placement::with_derived(
             site.samples[k], table.scorecard.parameters, table.places[index].shape)) {
      auto& list = values[name];
      list.resize(site.samples.size(), std::nan(""));
      list[k] = value;
    }
  return values;
}

double known_median(std::vector<double> values) {
  std::erase_if(values, [](double v) { return !std::isfinite(v); });
  return median(values);
}

const char* word(placement::Tolerance::End end) {
  return end == placement::Tolerance::End::score     ? "score"
         : end == placement::Tolerance::End::outline ? "outline"
                                                     : "reach";
}

/// Sites that fail altogether are not better or worse than each other.
bool fails_or_unrated(const placement::RankedSite& site) {
  return !site.score.rated() || site.score.robust <= 0;
}

bool shared(const placement::RankedSite& site, const placement::Ranking& ranking) {
  return std::count_if(
             ranking.sites.begin(), ranking.sites.end(),
             [&](const placement::RankedSite& other) { return other.rank == site.rank; }) > 1;
}

std::string range(const std::optional<placement::Interval>& interval, int decimals) {
  if (!interval) return {};
  return fmt::format("{:.{}f}-{:.{}f}", interval->low, decimals, interval->high, decimals);
}

/// The sample that a robust score is that of, by name, where there are several.
std::string worst_sample(const placement::RankingTable& table, const placement::RankedSite& site) {
  const int sample = site.score.robust_sample;
  return table.sample_names.size() > 1 && sample >= 0 &&
                 sample < static_cast<int>(table.sample_names.size())
             ? table.sample_names[sample]
             : "";
}

/// "back 102, -35": where in the pattern [mm].
std::string place_text(const placement::RankedPlace& place) {
  return fmt::format("{} {:.0f}, {:.0f}", printable(place.panel), 1e3 * place.at.x(),
                     1e3 * place.at.y());
}

/// Cells of the terminal table; with one sample there is nothing to say on spread.
std::vector<std::string> text_row(const placement::RankingTable& table,
                                  const placement::RankedSite& site) {
  const placement::Ranking& ranking = table.ranking;
  const placement::SiteScore& score = site.score;
  const bool many = ranking.samples > 1;
  if (!score.rated()) {
    std::vector<std::string> row = {"-", printable(site.name), place_text(table.places[site.index]),
                                    fmt::format("<= {:.2f}", score.bound)};
    if (many) row.insert(row.end(), {"", "", "", ""});
    row.push_back(terminal_line(score.reason));
    return row;
  }
  std::vector<std::string> row = {rank_text(site, ranking), printable(site.name),
                                  place_text(table.places[site.index]),
                                  fmt::format("{:.2f}", score.robust)};
  if (many)
    row.insert(row.end(),
               {range(site.robust_interval, 2), fmt::format("{:.2f}", score.median),
                fmt::format("{:.0f} %", 100 * score.passing), range(site.rank_interval, 0)});
  const std::string sample = worst_sample(table, site);
  row.push_back(terminal_line(score.reason) +
                (sample.empty() ? "" : " (" + printable(sample) + ")"));
  return row;
}

/// To a hundredth of a micrometre or degree: 0.0175, not 0.017499999999999998.
double readable(double value) { return std::round(value * 1e8) / 1e8; }

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json interval_json(const std::optional<placement::Interval>& interval) {
  return interval ? Json{interval->low, interval->high} : Json(nullptr);
}

Json tolerance_json(const std::optional<placement::Tolerance>& tolerance) {
  if (!tolerance) return nullptr;
  return {{"along_mm", 1e3 * tolerance->along},
          {"around_mm", 1e3 * tolerance->around},
          {"along_ends_at", word(tolerance->along_end)},
          {"around_ends_at", word(tolerance->around_end)},
          {"along_in_pattern", {tolerance->direction.x(), tolerance->direction.y()}}};
}

Json address_json(const std::optional<placement::BodyAddress>& address) {
  if (!address) return nullptr;
  const Vec3& percent = address->percent;
  return {{"words", address->str()},
          {"segment", placement::name(address->segment)},
          {"side", io::side_name(*address)},
          {"percent", {percent.x(), percent.y(), percent.z()}}};
}

Json site_json(const placement::RankingTable& table, const placement::RankedSite& site) {
  const placement::RankedPlace& place = table.places[site.index];
  const placement::SiteScore& score = site.score;
  const bool rated = score.rated();
  Json json = {{"name", site.name},
               {"rank", fails_or_unrated(site) ? Json(nullptr) : Json(site.rank)},
               {"rank_interval", interval_json(site.rank_interval)},
               {"tied_with", site.tied_with},
               {"score_robust", rated ? Json(score.robust) : Json(nullptr)},
               {"score_robust_interval", interval_json(site.robust_interval)},
               {"score_median", rated ? Json(score.median) : Json(nullptr)},
               {"score_median_interval", interval_json(site.median_interval)},
               {"score_bound", score.bound},
               {"passing", rated ? Json(score.passing) : Json(nullptr)},
               {"scores", score.samples},
               {"limiting_metric", rated ? Json(score.metric) : Json(nullptr)},
               {"limiting_reason", score.reason},
               {"limiting_sample", worst_sample(table, site)},
               {"missing", score.missing},
               {"region", place.region},
               {"panel", place.panel},
               {"u_m", readable(place.at.x())},
               {"v_m", readable(place.at.y())},
               {"angle_deg", readable(degrees(place.angle))},
               {"position_m", {place.position.x(), place.position.y(), place.position.z()}},
               {"to_seam_mm", number(1e3 * place.to_seam)},
               {"to_edge_mm", number(1e3 * place.to_edge)},
               {"body_address", address_json(place.anatomy)},
               {"footprint", Json::parse(pipeline::footprint_json(place.shape))},
               {"tolerance", tolerance_json(place.tolerance)}};
  Json& metrics = json["metrics"] = Json::object();
  for (const auto& [name, values] : by_metric(table, site.index)) {
    Json list = Json::array();
    for (double value : values) list.push_back(number(value));
    metrics[name] = list;
  }
  return json;
}

std::vector<std::string> csv_row(const placement::RankingTable& table,
                                 const placement::RankedSite& site,
                                 const std::set<std::string>& metrics) {
  const placement::RankedPlace& place = table.places[site.index];
  const placement::SiteScore& score = site.score;
  const auto rated = [&](double v) { return score.rated() ? io::csv_field(v) : std::string(); };
  std::vector<std::string> row = {fails_or_unrated(site) ? "" : std::to_string(site.rank),
                                  io::csv_field(site.name), rated(score.robust),
                                  rated(score.median), rated(score.passing)};
  for (const auto& interval : {site.robust_interval, site.median_interval, site.rank_interval}) {
    row.push_back(interval ? io::csv_field(interval->low) : "");
    row.push_back(interval ? io::csv_field(interval->high) : "");
  }
  for (const std::string& text :
       {join(site.tied_with, "; "), score.rated() ? score.metric : "", score.reason,
        worst_sample(table, site), place.region, place.panel})
    row.push_back(io::csv_field(text));
  for (double v :
       {place.at.x(), place.at.y(), degrees(place.angle), place.position.x(), place.position.y(),
        place.position.z(), 1e3 * place.to_seam, 1e3 * place.to_edge})
    row.push_back(io::csv_field(readable(v)));
  for (const std::string& text : io::address_fields(place.anatomy)) row.push_back(text);
  row.push_back(io::csv_field(in_words(place.shape)));
  row.push_back(place.tolerance ? io::csv_field(1e3 * place.tolerance->along) : "");
  row.push_back(place.tolerance ? io::csv_field(1e3 * place.tolerance->around) : "");
  const auto values = by_metric(table, site.index);
  for (const std::string& metric : metrics)
    row.push_back(values.count(metric) ? io::csv_field(known_median(values.at(metric))) : "");
  return row;
}

}  // namespace

std::vector<std::string> ranking_notes(const placement::RankingTable& table) {
  std::vector<std::string> notes = table.ranking.notes;
  if (!table.scorecard.left_out.empty()) {
    std::vector<std::string> left_out;
    for (const std::string& metric : table.scorecard.left_out)
      left_out.push_back(placement::metric_with_need(metric));
    notes.push_back("scores are upper bounds: not looked at: " + join(left_out));
  }
  notes.insert(notes.end(), table.notes.begin(), table.notes.end());
  std::vector<std::string> presets, own;
  for (const placement::UncoveredSite& site : table.uncovered)
    (site.preset ? presets : own)
        .push_back(site.preset ? site.name : site.name + " (" + site.why + ")");
  if (!own.empty()) notes.push_back("not covered by the garment, so not ranked: " + join(own));
  if (!presets.empty())
    notes.push_back("presets that the garment does not cover: " + join(presets));
  return notes;
}

std::string rank_text(const placement::RankedSite& site, const placement::Ranking& ranking) {
  if (fails_or_unrated(site)) return "-";
  return std::to_string(site.rank) + (shared(site, ranking) ? "=" : "");
}

std::string ranking_verdict(const placement::RankingTable& table) {
  if (table.ranking.sites.empty()) return {};
  const placement::RankedSite& first = table.ranking.sites.front();
  const placement::SiteScore& score = first.score;
  if (!score.rated()) return "no site can be rated: " + first.name + " is " + score.reason;
  if (score.robust >= table.scorecard.pass) return {};
  if (score.robust <= 0 && table.ranking.sites.size() > 1)
    return fmt::format("no site passes: all score 0 of {:g}; {}: {}", table.scorecard.pass,
                       first.name, score.reason);
  return fmt::format("no site passes: {}, the nearest to it, scores {:.2f} of {:g}: {}", first.name,
                     score.robust, table.scorecard.pass, score.reason);
}

std::string ranking_text(const placement::RankingTable& table) {
  const char* const place = "panel u, v [mm]";
  std::vector<std::vector<std::string>> rows = {{"rank", "site", place, "score", "limited by"}};
  if (table.ranking.samples > 1)
    rows = {{"rank", "site", place, "score", "90 %", "median", "pass", "rank 90 %", "limited by"}};
  for (const placement::RankedSite& site : table.ranking.sites)
    rows.push_back(text_row(table, site));
  std::vector<std::size_t> width(rows[0].size(), 0);
  for (const auto& row : rows)
    for (std::size_t c = 0; c < row.size(); ++c) width[c] = std::max(width[c], row[c].size());
  const int samples = table.ranking.samples;
  std::string text =
      fmt::format("{}: {} {}, passes from {:g}\n", terminal_line(table.scorecard.title), samples,
                  samples == 1 ? "sample" : "samples", table.scorecard.pass);
  if (const std::string verdict = ranking_verdict(table); !verdict.empty())
    text += terminal_line(verdict) + "\n";
  for (const auto& row : rows) {
    std::string line;
    for (std::size_t c = 0; c < row.size(); ++c) line += fmt::format("{:{}}  ", row[c], width[c]);
    text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  for (const std::string& note : ranking_notes(table))
    text += "note: " + terminal_line(note) + "\n";
  return text;
}

std::string ranking_csv(const placement::RankingTable& table) {
  std::set<std::string> metrics;
  for (std::size_t i = 0; i < table.sites.size(); ++i)
    for (const auto& entry : by_metric(table, static_cast<int>(i))) metrics.insert(entry.first);
  // clang-format off
  std::vector<std::string> head = {
      "rank", "name", "score_robust", "score_median", "passing", "robust_low", "robust_high",
      "median_low", "median_high", "rank_low", "rank_high", "tied_with", "limiting_metric",
      "limiting_reason", "limiting_sample", "region", "panel", "u_m", "v_m", "angle_deg", "x_m",
      "y_m", "z_m", "to_seam_mm", "to_edge_mm"};
  // clang-format on
  head.insert(head.end(), io::address_columns().begin(), io::address_columns().end());
  head.insert(head.end(), {"footprint", "tolerance_along_mm", "tolerance_around_mm"});
  head.insert(head.end(), metrics.begin(), metrics.end());
  std::string text = io::csv_line(head);
  for (const placement::RankedSite& site : table.ranking.sites)
    text += io::csv_line(csv_row(table, site, metrics));
  return text;
}

std::string ranking_json(const placement::RankingTable& table) {
  Json json = {{"modality", table.scorecard.name},   {"title", table.scorecard.title},
               {"about", table.scorecard.about},     {"pass", table.scorecard.pass},
               {"samples", table.ranking.samples},   {"draws_of", table.ranking.draws_of},
               {"sample_names", table.sample_names}, {"left_out", table.scorecard.left_out},
               {"notes", ranking_notes(table)}};
  json["verdict"] = ranking_verdict(table);
  json["uncovered"] = Json::array();
  for (const placement::UncoveredSite& site : table.uncovered)
    json["uncovered"].push_back({{"name", site.name}, {"preset", site.preset}, {"why", site.why}});
  Json& sites = json["sites"] = Json::array();
  for (const placement::RankedSite& site : table.ranking.sites)
    sites.push_back(site_json(table, site));
  return json_without_controls(json.dump(2, ' ', false, Json::error_handler_t::replace)) + "\n";
}

std::vector<std::string> ranking_files(const std::string& scorecard) {
  return {"ranking-" + scorecard + ".csv", "ranking-" + scorecard + ".json",
          "sewing-plan-" + scorecard + ".svg", "sewing-plan-" + scorecard + ".dxf"};
}

void write_ranking(const std::filesystem::path& folder, const placement::RankingTable& table,
                   const pattern::Pattern& pattern, const pipeline::CaseResult* lines) {
  const std::vector<std::string> files = ranking_files(table.scorecard.name);
  io::write_text_file((folder / files[0]).string(), ranking_csv(table));
  io::write_text_file((folder / files[1]).string(), ranking_json(table));
  io::write_text_file((folder / files[2]).string(), sewing_plan_svg(table, pattern, lines));
  std::vector<io::PatternMark> marks = pipeline::ranking_marks(table);
  if (lines)
    for (io::PatternMark& mark : line_marks_of(*lines)) marks.push_back(std::move(mark));
  io::write_dxf(folder / files[3], pattern, {}, marks);
}

}  // namespace loosefit::report

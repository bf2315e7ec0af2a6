#include "loosefit/pipeline/answers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "loosefit/base/quantile.h"
#include "loosefit/base/text.h"
#include "loosefit/io/scorecard_file.h"
#include "loosefit/maps/mesh_error.h"
#include "loosefit/pipeline/case_sites.h"
#include "loosefit/pipeline/place_in_words.h"
#include "loosefit/pipeline/rank_case.h"
#include "loosefit/pipeline/wear_states.h"
#include "loosefit/placement/catalogue_metrics.h"

namespace loosefit::pipeline {
namespace {

/// Decimals of two digits: no quantity is known better.
int decimals_of(double value) {
  const double digits = 1 - std::floor(std::log10(std::abs(value)));
  return value == 0 || !std::isfinite(digits) ? 0 : static_cast<int>(std::clamp(digits, 0.0, 9.0));
}

std::string number_words(double value) {
  if (!std::isfinite(value)) return "unknown";
  const int decimals = decimals_of(value);
  std::string text = fmt::format("{:.{}f}", value, decimals);
  if (decimals > 0) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.ends_with('.')) text.pop_back();
  }
  return text == "-0" ? "0" : text;
}

/// Both ends as exactly as the one that is farther from zero.
std::string interval_words(double low, double high) {
  const int decimals = decimals_of(std::max(std::abs(low), std::abs(high)));
  return fmt::format("{:.{}f} to {:.{}f}", low, decimals, high, decimals);
}

/// "3.5 degrees", "0.65 kPa".
std::string value_words(double value, const std::string& unit) {
  const std::string number = number_words(value);
  return unit == "-" ? number : number + " " + (unit == "deg" ? "degrees" : unit);
}

std::string unit_of(const std::string& metric) {
  const placement::MetricName* name = placement::find_metric(metric);
  return name ? name->unit : "-";
}

std::string words_of(const std::string& metric) {
  const placement::MetricName* name = placement::find_metric(metric);
  return name ? name->words : metric;
}

std::string sentence(std::string text) {
  if (text.empty()) return text;
  text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  if (!text.ends_with('.')) text += '.';
  return text;
}

/// Of a score with all needs met the reason says what comes nearest to limiting.
std::string limit_words(const std::string& reason) {
  return sentence(reason.starts_with("all needs met") ? reason : "What limits it: " + reason);
}

/// The value of a criterion that scores the pass mark.
double mark(const placement::Ramp& ramp, double pass) {
  return ramp.fail + pass * (ramp.good - ramp.fail);
}

/// "contact pressure, mean of the footprint between 0.65 and 3.7 kPa".
std::string mark_words(const placement::Criterion& criterion, double pass) {
  const std::string unit = unit_of(criterion.metric);
  const double first = mark(criterion.limit, pass);
  const std::string what = words_of(criterion.metric);
  if (criterion.upper)
    return fmt::format("{} from {} to {}", what, number_words(first),
                       value_words(mark(*criterion.upper, pass), unit));
  return fmt::format("{} {} {}", what,
                     criterion.limit.good > criterion.limit.fail ? "at least" : "at most",
                     value_words(first, unit));
}

/// What the criteria that a run cannot tell are about, and what they need.
std::string untold(const placement::Scorecard& card) {
  std::vector<std::string> words;
  for (const std::string& metric : card.left_out)
    words.push_back(words_of(metric) + " (needs " + placement::find_metric(metric)->needs + ")");
  return join(words, "; ");
}

std::string pass_mark(const placement::Scorecard& card) {
  std::vector<std::string> marks;
  for (const placement::Criterion& criterion : card.criteria)
    marks.push_back(mark_words(criterion, card.pass));
  std::string text = "Pass mark: " + join(marks, "; ");
  if (!card.left_out.empty()) text += ". Not judged: " + untold(card);
  return sentence(text);
}

const placement::Criterion* find_criterion(const placement::Scorecard& card,
                                           const std::string& metric) {
  for (const placement::Criterion& criterion : card.criteria)
    if (criterion.metric == metric) return &criterion;
  return nullptr;
}

/// What commonly moves a metric the right way.
std::string advice(const std::string& metric, bool too_much) {
  if (metric.starts_with("pressure"))
    return too_much ? "more ease there" : "less ease there, or an elastic band or cuff";
  if (metric.starts_with("contact") || metric.starts_with("gap") ||
      metric.starts_with("temperature") || metric.starts_with("capacitance"))
    return "less ease there, a stretchier cloth, or a band";
  if (metric.starts_with("coe") || metric.starts_with("slip") || metric.starts_with("donning"))
    return "a closer fit or a band there, a cloth that grips, or a place that moves less";
  if (metric.starts_with("angular") || metric.starts_with("rotation") ||
      metric.starts_with("tilt") || metric.starts_with("twist"))
    return "a closer fit there, or a calibration after dressing";
  if (metric == "usable_signal_ratio") return "postures or a breath that stretch the place more";
  return "another place, fit or cloth";
}

/// Values of one metric of one ranked place over its samples.
std::vector<double> values_of(const placement::RankingTable& table, int index,
                              const std::string& metric) {
  std::vector<double> values;
  for (const placement::MetricValues& sample : table.sites[index].samples)
    if (const auto at = sample.find(metric); at != sample.end() && std::isfinite(at->second))
      values.push_back(at->second);
  return values;
}

std::string of_samples(int samples, int people) {
  if (samples <= 1) return "one donning of one person";
  return fmt::format("least and greatest of {} donnings of {}", samples,
                     people == 1 ? "one person" : fmt::format("{} people", people));
}

/// Error of the mesh in a metric of the catalogue.
std::optional<double> mesh_error_of(const std::string& metric, double value, double edge_length) {
  for (const placement::CatalogueMetric& known : placement::catalogue_metrics())
    if (known.metric->name == metric)
      return maps::mesh_error(known.array->style.array, value, edge_length);
  return {};
}

void add_expectation(const placement::RankingTable& table, int index, double edge_length,
                     Answer& answer) {
  for (const placement::Criterion& criterion : table.scorecard.criteria) {
    const std::vector<double> values = values_of(table, index, criterion.metric);
    if (values.empty()) continue;
    answer.metric = criterion.metric;
    answer.unit = unit_of(criterion.metric);
    answer.expected = median(values);
    answer.low = *std::min_element(values.begin(), values.end());
    answer.high = *std::max_element(values.begin(), values.end());
    answer.mesh_error = mesh_error_of(answer.metric, answer.expected, edge_length);
    const double error = answer.mesh_error.value_or(0);
    const bool interval = error > 0 || values.size() > 1;
    const double low = answer.low >= 0 ? std::max(0.0, answer.low - error) : answer.low - error;
    answer.expectation = fmt::format(
        "Expect {}: {} ({}{}, {}).", words_of(criterion.metric),
        value_words(answer.expected, answer.unit),
        interval ? interval_words(low, answer.high + error) + ": " : "",
        of_samples(static_cast<int>(values.size()), answer.people),
        answer.mesh_error ? "with the error of the mesh" : "error of the mesh not known");
    return;
  }
}

/// The criterion whose interval holds the pass mark, of a place that none fails for certain: the
/// verdict may then be chance. Null: there is none.
const placement::Criterion* open_criterion(const placement::RankingTable& table, int index,
                                           double edge_length) {
  const placement::Criterion* open = nullptr;
  for (const placement::Criterion& criterion : table.scorecard.criteria) {
    const std::vector<double> values = values_of(table, index, criterion.metric);
    if (values.empty()) continue;
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    const double error = mesh_error_of(criterion.metric, median(values), edge_length).value_or(0);
    switch (placement::outlook(criterion, table.scorecard.pass, *least - error, *most + error)) {
      case placement::Outlook::fails:
        return nullptr;
      case placement::Outlook::open:
        if (!open) open = &criterion;
        break;
      case placement::Outlook::passes:
        break;
    }
  }
  return open;
}

/// What would tell whether a place passes: a finer mesh whose interval no longer holds the mark, or
/// a place with more room.
std::string deciding_words(const CaseResult& result, const placement::RankingTable& table,
                           int index, const placement::Criterion& open) {
  constexpr double kFinest = 0.005, kPower = 2.5;  // of time over vertices, study/plan.cpp
  const double edge = result.scenario.simulation.edge_length;
  const double finer = std::max(kFinest, edge / 2);
  const std::vector<double> values = values_of(table, index, open.metric);
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  const double error = mesh_error_of(open.metric, median(values), finer).value_or(0);
  if (finer < 0.9 * edge && placement::outlook(open, table.scorecard.pass, *least - error,
                                               *most + error) != placement::Outlook::open) {
    double seconds = 0;
    for (const StageClock::Entry& entry : result.seconds) seconds += entry.seconds;
    return fmt::format("Edges of {:.2g} mm would tell, in some {:.0f} minutes.", 1e3 * finer,
                       std::max(1.0, seconds * std::pow(edge / finer, kPower) / 60));
  }
  return "A place, fit or cloth with more room to the pass mark would tell.";
}

/// What the limiting criterion would have to be, of a place that does not pass.
std::string need_words(const placement::RankingTable& table, const placement::RankedSite& site) {
  const placement::Scorecard& card = table.scorecard;
  const placement::Criterion* criterion = find_criterion(card, site.score.metric);
  if (!criterion) return {};
  const std::vector<double> values = values_of(table, site.index, site.score.metric);
  if (values.empty()) return {};
  bool above = false;
  // Of the sample that the robust score is that of.
  const int worst = site.score.robust_sample;
  const double value =
      worst >= 0 && worst < static_cast<int>(values.size()) ? values[worst] : median(values);
  criterion->ramp(value, &above);
  const placement::Ramp& ramp = above ? *criterion->upper : criterion->limit;
  const bool too_much = ramp.good < ramp.fail;
  return fmt::format("It would need {} {} instead of {}: {}.", too_much ? "at most" : "at least",
                     value_words(mark(ramp, card.pass), unit_of(criterion->metric)),
                     value_words(value, unit_of(criterion->metric)),
                     advice(criterion->metric, too_much));
}

body::Region region_named(const std::string& name) {
  return body::find_region(name).value_or(body::Region::chest);
}

Answer answer_at(const CaseResult& result, const placement::RankingTable& table,
                 const placement::RankedSite& site, bool best) {
  const placement::RankedPlace& place = table.places[site.index];
  const placement::SiteScore& score = site.score;
  Answer answer;
  answer.modality = table.scorecard.name;
  answer.sensor = table.scorecard.title;
  answer.site = site.name;
  answer.panel = place.panel;
  answer.at = place.at;
  answer.angle = place.angle;
  answer.shape = place.shape;
  answer.samples = table.ranking.samples;
  answer.pass_mark = pass_mark(table.scorecard);
  // Scores of a part of the criteria are upper bounds: they can fail a place, not pass it.
  const bool whole = table.scorecard.left_out.empty();
  const bool so_far = score.rated() && score.robust >= table.scorecard.pass;
  const double edge = result.scenario.simulation.edge_length;
  add_expectation(table, site.index, edge, answer);
  const placement::Criterion* open =
      score.rated() ? open_criterion(table, site.index, edge) : nullptr;
  if (score.rated() && !open && (whole || !so_far)) answer.passes = so_far;
  const std::string where =
      place_on_body(result.body.body.body(), region_named(place.region), place.anatomy) + " (" +
      place_on_panel(result.studied().pattern.pattern, place.panel, place.at) + ")";
  if (!best)
    answer.place = "At " + site.name + ", " + where + ".";
  else if (answer.passes.value_or(false))
    answer.place = "Sew it on " + where + ".";
  else if (answer.passes)
    answer.place = "No place passes; the best is " + where + ".";
  else if (score.rated())
    answer.place = "The best place is " + where + ".";
  else
    answer.place = "No place can be rated; the first is " + where + ".";
  if (!score.rated()) {
    answer.verdict = sentence(score.reason);
    return answer;
  }
  for (double q : score.samples) answer.passing += q >= table.scorecard.pass;
  answer.verdict =
      answer.samples == 1
          ? fmt::format("It {}.", answer.passing ? "passes" : "does not pass")
          : fmt::format("It passes in {} of {} donnings.", answer.passing, answer.samples);
  if (!whole && so_far)
    answer.verdict = "Undecided: what this run can tell passes, but it cannot tell " +
                     untold(table.scorecard) + ".";
  answer.limit = limit_words(score.reason);
  if (open) {
    answer.verdict = "Undecided: the interval of " + words_of(open->metric) +
                     " holds the pass mark. " + answer.verdict;
    answer.need = deciding_words(result, table, site.index, *open);
  } else if (!so_far) {
    answer.need = need_words(table, site);
  }
  return answer;
}

/// The best place, of those that the sensor is meant for where it says so.
const placement::RankedSite* best_of(const placement::RankingTable& table) {
  const std::vector<body::Region>& meant = table.scorecard.regions;
  for (const placement::RankedSite& site : table.ranking.sites) {
    const body::Region region = region_named(table.places[site.index].region);
    if (meant.empty() || std::find(meant.begin(), meant.end(), region) != meant.end()) return &site;
  }
  return table.ranking.sites.empty() ? nullptr : &table.ranking.sites.front();
}

bool wished(const CaseResult& result, const std::string& name) {
  return std::any_of(result.scenario.sites.begin(), result.scenario.sites.end(),
                     [&](const placement::SiteSpec& spec) { return spec.name == name; });
}

/// The best place of a table, and the other places that were asked for by name.
void add_ranked(const CaseResult& result, const placement::RankingTable& table, bool asked,
                std::vector<Answer>& answers) {
  const placement::RankedSite* best =
      asked && !table.ranking.sites.empty() ? &table.ranking.sites.front() : best_of(table);
  if (!best) return;
  const std::string plan = "sewing-plan-" + table.scorecard.name;
  const auto add = [&](const placement::RankedSite& site, bool is_best) {
    answers.push_back(answer_at(result, table, site, is_best));
    answers.back().asked = asked;
    if (asked) answers.back().files = {plan + ".svg", plan + ".dxf"};
    answers.back().files.push_back("pattern.json");
  };
  add(*best, true);
  for (const placement::RankedSite& site : table.ranking.sites)
    if (asked && &site != best && wished(result, site.name)) add(site, false);
}

void add_line(const CaseLine& line, const CaseLine::Verdict& verdict,
              std::vector<Answer>& answers) {
  Answer answer;
  answer.modality = verdict.scorecard;
  answer.sensor = verdict.title;
  answer.site = line.name;
  answer.asked = true;
  answer.samples = static_cast<int>(line.metrics.size());
  answer.place =
      fmt::format("Sew the line {} as lines.svg shows it, {:.1f} cm long in the flat cloth.",
                  line.name, 100 * line.course.length);
  if (verdict.score.q) {
    answer.passes = verdict.passes();
    answer.verdict = fmt::format("It {} in the donning that does worst.",
                                 *answer.passes ? "passes" : "does not pass");
    answer.limit = limit_words(verdict.score.reason);
    answer.passing = *answer.passes ? answer.samples : 0;
  } else {
    answer.verdict = sentence(verdict.score.reason);
  }
  answer.files = {"lines.svg", "lines.dxf"};
  answers.push_back(std::move(answer));
}

/// The tables of the usual sensors at the places of this case.
void add_usual(const CaseResult& result, std::vector<Answer>& answers) {
  std::vector<placement::Site> sites = find_case_sites(result).sites;
  // Places that were asked for are what the reader wants to know of.
  const auto is_preset = [](const placement::Site& site) { return site.preset; };
  if (!std::all_of(sites.begin(), sites.end(), is_preset)) std::erase_if(sites, is_preset);
  if (sites.empty()) return;
  const CaseGarment& garment = result.studied();
  const placement::SiteMeter meter(garment.mesh(), result.scenario.studied().material.material,
                                   worn_states(result));
  const placement::RankingGround ground{garment.mesh(), garment.drape.positions, result.body.body,
                                        garment.maps.worn, meter};
  const bool postures = result.wear.postures.size() > 1;
  for (const char* modality :
       {postures ? "imu-inclination" : "imu-uncalibrated", "ecg", "ppg", "strain-respiration"}) {
    placement::RankingWish wish;
    wish.scorecard = io::load_scorecard(modality);
    wish.sites = sites;
    wish.partial = true;
    wish.tolerances = false;
    wish.rank.seed = result.scenario.simulation.seed;
    add_ranked(result, placement::make_ranking(ground, wish), false, answers);
  }
}

}  // namespace

std::string Answer::text() const {
  std::vector<std::string> said = {place, expectation, verdict, limit, need};
  std::erase(said, "");
  return join(said, " ");
}

std::vector<Answer> make_answers(const CaseResult& result, const placement::RankingTable* ranking) {
  std::vector<Answer> answers;
  if (result.studied().maps.maps.empty()) return answers;
  if (ranking) add_ranked(result, *ranking, true, answers);
  for (const CaseLine& line : result.lines) {
    // Of all shipped scorecards only those that can judge it; else what they lack.
    const bool rated = std::any_of(line.verdicts.begin(), line.verdicts.end(),
                                   [](const auto& v) { return v.score.q.has_value(); });
    for (const CaseLine::Verdict& verdict : line.verdicts)
      if (!rated || verdict.score.q) add_line(line, verdict, answers);
  }
  if (answers.empty()) add_usual(result, answers);
  return answers;
}

}  // namespace loosefit::pipeline

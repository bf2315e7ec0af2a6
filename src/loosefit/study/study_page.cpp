#include "loosefit/study/study_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "loosefit/base/quantile.h"
#include "loosefit/base/text.h"
#include "loosefit/base/version.h"
#include "loosefit/placement/metric_names.h"
#include "loosefit/report/html.h"
#include "loosefit/report/plot.h"
#include "loosefit/report/report_style.h"
#include "loosefit/report/svg.h"
#include "loosefit/study/cautions.h"
#include "loosefit/study/run_study.h"
#include "loosefit/study/unit_words.h"

namespace loosefit::study {
namespace {

using report::element;
using report::escaped;
using report::fixed;

/// Curves that one plot can bear.
constexpr std::size_t kMostCurves = 5;
/// Robust scores are not clamped, so that those that fail still differ; drawn down to here.
constexpr double kLeastDrawn = -1;
/// Rows of a table of sensitivity.
constexpr std::size_t kMostSensitivities = 12;

std::string score(double value) {
  return std::isnan(value) ? "–" : fixed(std::clamp(value, 0.0, 1.0), 2);
}
std::string bounds(const Bounds& b, int decimals) {
  if (std::isnan(b.low)) return "–";
  return fixed(b.low, decimals) + " to " + fixed(b.high, decimals);
}
std::string score_bounds(const Bounds& b) {
  return std::isnan(b.low) ? "–" : score(b.low) + " to " + score(b.high);
}
std::string percent(double share) { return std::isnan(share) ? "–" : fixed(100 * share, 0) + " %"; }

std::string metric_words(const std::string& metric) {
  const placement::MetricName* name = placement::find_metric(metric);
  return name ? name->words : metric;
}

std::string limit_text(const HowLoose& answer, const StudyData& data) {
  if (answer.at_most == -kInfinity) return "at no fit tried";
  if (answer.limit == -kInfinity) return "at no fit rated";
  if (answer.limit == kInfinity) return "≥ " + fixed(data.level_bgm.back(), 2);
  return (answer.at_most > answer.limit ? "≥ " : "") + fixed(answer.limit, 2);
}

std::string end_text(double limit) {
  if (limit == -kInfinity) return "nowhere";
  if (limit == kInfinity) return "beyond";
  return fixed(limit, 2);
}

/// The fit at which most people pass: "58 % at 0.02".
std::string most_passing_text(const HowLoose& answer) {
  const LoosePoint* most = most_passing(answer);
  if (!most) return "–";
  return most->passing > 0 ? percent(most->passing) + " at " + fixed(most->bgm, 2) : "none";
}

std::string interval_text(const Bounds& ends) {
  const std::string low = end_text(ends.low), high = end_text(ends.high);
  return low == high ? low : low + " to " + high;
}

/// Sites with the loosest limit first.
std::vector<std::pair<std::string, const HowLoose*>> by_limit(const ModalityAnalysis& modality) {
  std::vector<std::pair<std::string, const HowLoose*>> sites;
  for (const auto& [site, answer] : modality.how_loose) sites.emplace_back(site, &answer);
  const auto best = [](const HowLoose& answer) {
    double most = -kInfinity;
    for (const LoosePoint& p : answer.curve)
      if (!std::isnan(p.robust)) most = std::max(most, p.robust);
    return most;
  };
  std::stable_sort(sites.begin(), sites.end(), [&](const auto& a, const auto& b) {
    if (a.second->limit != b.second->limit) return a.second->limit > b.second->limit;
    return best(*a.second) > best(*b.second);
  });
  return sites;
}

/// Whether each kind of sensor works for 95 % of people somewhere, at some fit.
bool all_work(const StudyAnalysis& analysis) {
  if (analysis.modalities.empty()) return false;
  return std::ranges::all_of(analysis.modalities, [](const ModalityAnalysis& modality) {
    if (modality.how_loose.empty())
      return !modality.rankings.empty() && !modality.rankings.back().empty() &&
             modality.rankings.back().front().p5 >= modality.pass;
    return std::ranges::any_of(modality.how_loose,
                               [](const auto& site) { return site.second.limit > -kInfinity; });
  });
}

std::string head(const StudyAnalysis& analysis) {
  const StudyData& data = analysis.data;
  const int n = static_cast<int>(data.units.size());
  const int cases = static_cast<int>(data.plan.cases.size());
  std::string of = counted(n, unit_kind(data));
  if (people_axis(data.plan) >= 0) of += ", " + counted(cases, "case", "cases");
  std::string text = element("h1", escaped(data.plan.name));
  text += element("p",
                  escaped(of + ", " + counted(data.drapes, "drape", "drapes") + "; " +
                          counted(data.scored, "case has scores.", "cases have scores.")),
                  "lead");
  std::string list;
  for (const std::string& sentence : headlines(analysis)) list += element("li", escaped(sentence));
  const bool asked = !data.modalities.empty();
  const int missing = cases - (asked ? data.scored : data.done);
  text += element("div",
                  element("strong", looseness_axis(data.plan) >= 0 ? "How loose may it be?"
                                                                   : "Where does it work?") +
                      element("ul", list),
                  std::string("box ") + (missing == 0 && all_work(analysis) ? "good" : "warn"));
  if (missing > 0)
    text +=
        element("div",
                escaped(fmt::format("{} of {} {} no {}: listed below, counted neither as "
                                    "passing nor as failing.",
                                    missing, counted(cases, "case", "cases"),
                                    missing == 1 ? "has" : "have", asked ? "scores" : "result")),
                "box warn");
  return text;
}

std::string loose_section(const StudyAnalysis& analysis, const ModalityAnalysis& modality) {
  if (modality.how_loose.empty()) return "";
  const StudyData& data = analysis.data;
  report::Plot plot;
  plot.x_label = "body-garment mobility (" + data.plan.looseness + ")";
  const UnitKind kind = unit_kind(data);
  plot.y_label = kind == UnitKind::people ? "score that 95 % of people reach (drawn from -1 on)"
                                          : "5th percentile of the scores of the " +
                                                column_name(kind) + " (drawn from -1 on)";
  const auto sites = by_limit(modality);
  for (const auto& [site, answer] : sites) {
    if (plot.series.size() >= kMostCurves) break;
    report::Plot::Series line;
    line.name = site;
    line.reference = true;
    for (const LoosePoint& p : answer->curve) {
      if (std::isnan(p.robust)) continue;
      line.x.push_back(p.bgm);
      line.y.push_back(std::clamp(p.robust, kLeastDrawn, 1.0));
    }
    if (!line.x.empty()) plot.series.push_back(line);
  }
  plot.series.push_back({"passes from here on",
                         {data.level_bgm.front(), data.level_bgm.back()},
                         {modality.pass, modality.pass},
                         true});
  if (analysis.comfort && std::isfinite(analysis.comfort->limit))
    plot.series.push_back({"comfortable to the right",
                           {analysis.comfort->limit, analysis.comfort->limit},
                           {0, 1},
                           true});
  report::Table table({"site", "loosest BGM that passes",
                       fmt::format("{:.0f} % interval", 100 * analysis.options.confidence),
                       "fails again tighter than", "most " + column_name(kind) + " pass",
                       "what limits"});
  for (const auto& [site, answer] : sites) {
    const auto limiting = modality.limiting.find(site);
    table.add({site, limit_text(*answer, data),
               std::isnan(answer->interval.low) ? "–" : interval_text(answer->interval),
               std::isinf(answer->tightest) || answer->limit == -kInfinity
                   ? "–"
                   : fixed(answer->tightest, 2),
               most_passing_text(*answer),
               limiting == modality.limiting.end() ? "–" : metric_words(limiting->second)});
  }
  std::string comfort;
  if (analysis.comfort)
    comfort = element("p", escaped("Comfort limit: the garment is " + in_words(*analysis.comfort) +
                                   " (" + for_most(analysis.comfort->units, kind) +
                                   " at most 1 % of its area presses with more than 4 kPa)."));
  return element("h3", "How loose may it be?") + report::svg_plot(plot) + table.html() + comfort;
}

std::string ranking_table(const std::vector<SitePopulation>& ranking, double confidence,
                          UnitKind kind) {
  const std::string interval = fmt::format("{:.0f} % interval", 100 * confidence);
  report::Table table({"site", "rank", "of ranks", "best of all", "median", interval,
                       "5th percentile", interval, "95th", "pass", column_name(kind), "tied with"});
  for (const SitePopulation& s : ranking)
    table.add({s.site, s.rank > 0 ? std::to_string(s.rank) : "–", bounds(s.rank_interval, 0),
               percent(s.first), score(s.median), score_bounds(s.median_interval), score(s.p5),
               score_bounds(s.robust_interval), score(s.p95), percent(s.passing),
               fmt::format("{} of {}", s.rated, s.people), join(s.tied_with)});
  return table.html();
}

std::string ranking_section(const StudyAnalysis& analysis, const ModalityAnalysis& modality) {
  if (modality.rankings.empty()) return "";
  const StudyData& data = analysis.data;
  const UnitKind kind = unit_kind(data);
  const bool several = data.level_bgm.size() > 1;
  std::string html =
      element("h3", several ? "Sites, over all fits together" : "Sites, best first") +
      ranking_table(modality.rankings.back(), analysis.options.confidence, kind);
  if (several)
    for (std::size_t k = 0; k < data.level_bgm.size(); ++k)
      html += "<details><summary>" +
              escaped("at " + data.plan.looseness + " " + data.level_labels[k]) + "</summary>" +
              ranking_table(modality.rankings[k], analysis.options.confidence, kind) +
              "</details>\n";
  std::vector<SiteScores> sites;
  for (const SitePopulation& s : modality.rankings.back())
    for (const SiteTable& table : data.sites.at(modality.name))
      if (table.site == s.site) sites.push_back({s.site, unit_scores(data, table, -1)});
  html += element("h3", "Scores of " + column_name(kind)) + distribution_svg(sites, modality.pass);
  if (!modality.sensors.empty()) {
    report::Table chosen({"sensors together", "mean over " + column_name(kind), "5th percentile"});
    std::string so_far;
    for (const SensorChoice& choice : modality.sensors) {
      so_far += (so_far.empty() ? "" : " + ") + choice.site;
      chosen.add({so_far, fixed(choice.mean, 3), fixed(choice.robust, 3)});
    }
    html += element("h3", "Several sensors, of which the best counts") + chosen.html();
  }
  return html;
}

/// Sites in the order of the ranking, as they stand above it.
std::string metric_table(const std::vector<MetricPercentiles>& metrics,
                         const std::vector<SitePopulation>& ranking, double confidence,
                         UnitKind kind) {
  const auto range = [](double low, double high) {
    return std::isnan(low) ? "–" : report::number(low) + " to " + report::number(high);
  };
  const std::string interval = fmt::format("{:.0f} % interval", 100 * confidence);
  report::Table table({"site", "what", "unit", "median", interval, "5th to 95th percentile",
                       "interval of the 95th", column_name(kind)});
  for (const SitePopulation& site : ranking)
    for (const MetricPercentiles& m : metrics) {
      if (m.site != site.site) continue;
      const placement::MetricName* name = placement::find_metric(m.metric);
      table.add({m.site, metric_words(m.metric), !name || name->unit == "-" ? "–" : name->unit,
                 report::number(m.median), range(m.median_interval.low, m.median_interval.high),
                 range(m.p5, m.p95), range(m.p95_interval.low, m.p95_interval.high),
                 fmt::format("{} of {}", m.known, m.people)});
    }
  return table.html();
}

std::string metric_section(const StudyAnalysis& analysis, const ModalityAnalysis& modality) {
  if (modality.metrics.empty() || modality.metrics.back().empty()) return "";
  const StudyData& data = analysis.data;
  const double confidence = analysis.options.confidence;
  const UnitKind kind = unit_kind(data);
  const bool people = people_axis(data.plan) >= 0;
  const bool several = data.level_bgm.size() > 1;
  std::string html =
      element("h3",
              std::string("What the sensors meet") + (several ? ", over all fits together" : "")) +
      metric_table(modality.metrics.back(), modality.rankings.back(), confidence, kind) +
      element("p",
              people ? "Percentiles over " + column_name(kind) +
                           " of what the scores are made of. Where somebody went through several "
                           "cases, the one that serves the sensor worst counts; of donnings the "
                           "mean. Who has no value is left out."
                     : "Percentiles over cases of what the scores are made of; of donnings the "
                       "mean. Cases without a value are left out.",
              "lead");
  if (several)
    for (std::size_t k = 0; k < data.level_bgm.size(); ++k)
      html += "<details><summary>" +
              escaped("at " + data.plan.looseness + " " + data.level_labels[k]) + "</summary>" +
              metric_table(modality.metrics[k], modality.rankings[k], confidence, kind) +
              "</details>\n";
  return html;
}

/// Correlations of few units are dashes, so they come last, in no order of theirs.
std::string sensitivity_section(const ModalityAnalysis& modality, UnitKind kind) {
  const auto is_shown = [](const Sensitivity* s) {
    return s->main_effect || s->units >= kFewestForInterval;
  };
  std::vector<const Sensitivity*> rows;
  for (const Sensitivity& s : modality.sensitivity)
    if (s.quantity == "score") rows.push_back(&s);
  if (rows.empty()) return "";
  const auto weight = [&](const Sensitivity* s) { return is_shown(s) ? std::abs(s->value) : -1; };
  std::ranges::stable_sort(rows, std::ranges::greater{}, weight);
  rows.resize(std::min(rows.size(), kMostSensitivities));
  report::Table table({"site", "input", "what", "value", "90 % interval"});
  for (const Sensitivity* s : rows)
    table.add({s->site, s->input, s->main_effect ? "share of variance" : "rank correlation",
               is_shown(s) ? report::signed_number(s->value, 2) : "–",
               is_shown(s) ? bounds(s->interval, 2) : "–"});
  const std::string few =
      std::ranges::all_of(rows, is_shown)
          ? ""
          : fmt::format(
                "Correlations of fewer than {} {} are not shown: chance alone makes large "
                "ones. ",
                kFewestForInterval, column_name(kind));
  return element("h3", "What the scores depend on most") + table.html() +
         element("p",
                 escaped(few + "Shares of variance are those that an axis explains by itself; "
                               "correlations are of ranks. All of them, and those of the metrics, "
                               "stand in study-report.json."),
                 "lead");
}

std::string trouble_section(const StudyData& data) {
  if (data.troubles.empty())
    return element("h2", "Failures") + element("p", "None: every case and every drape counts.");
  report::Table table({"case", "who and what", "status", "reason"});
  for (const CaseTrouble& t : data.troubles)
    table.add({std::to_string(t.number), t.label, t.status, metrics_in_words(t.reason)});
  return element("h2", "Failures") + table.html();
}

/// Certificate grades, and what the controls say of grade B.
std::string grade_text(const StudyData& data) {
  if (data.grade_b == 0) return element("p", "All cases have certificate grade A.");
  std::string text = element(
      "p",
      escaped(fmt::format(
          "{} of {} cases ended with certificate grade B: no vertex has more than 0.1 mm to go, "
          "99 % of normals no more than 0.2 degrees to turn. {} cases were run once more to grade "
          "A "
          "as controls{}.",
          data.grade_b, data.done, data.controls.cases,
          data.controls.failed > 0 ? fmt::format(", {} without coming there", data.controls.failed)
                                   : "")));
  const ScoreChanges& scores = data.controls.scores;
  if (scores.kept + scores.lost + scores.gained > 0)
    text += element(
        "p", escaped(fmt::format("{} of {} controls count their scores: of their samples {} have a "
                                 "score at both grades, {} lose it by going on to A and {} gain "
                                 "one.",
                                 data.controls.counted, data.controls.cases, scores.kept,
                                 scores.lost, scores.gained)));
  if (data.controls.largest.empty()) return text;
  report::Table table({"of all controls, sites and donnings", "greatest change by going on to A"});
  for (const auto& [metric, largest] : data.controls.largest)
    table.add({metric_words(metric), report::number(largest, 2)});
  return text + table.html();
}

/// What the number of people carries.
std::string people_text(const StudyData& data) {
  const int rated = rated_units(data), all = static_cast<int>(data.units.size());
  if (!is_sample(data) || rated == 0) return {};
  std::string text = fmt::format(
      "With {} the worst of them lies below the 5th percentile of their "
      "population with {:.0f} % confidence, whatever the distribution (59 make it 95 %). "
      "With 20 people or fewer the 5th percentile is the worst of them, and its interval "
      "reaches upwards only.",
      counted(rated, "independent person", "independent people"),
      100 * worst_of_n_confidence(rated, 1 - kRobustPeople));
  if (rated < all)
    text +=
        fmt::format(" {} of the {} {} no score at all: if they would fail, figures are too good.",
                    all - rated, all, all - rated == 1 ? "has" : "have");
  return element("p", escaped(text));
}

std::string method_section(const StudyAnalysis& analysis) {
  const StudyData& data = analysis.data;
  std::string text = element("h2", "How it was reckoned");
  const std::string units = column_name(unit_kind(data));
  text += element(
      "p",
      escaped((people_axis(data.plan) >= 0
                   ? "A person's score at a site is the lowest over all that the person went "
                     "through there: donnings, and whatever else varies."
                   : "A case's score at a site is the lowest over its donnings. Without an axis of "
                     "people nothing is said of people.") +
              (varies_by_chance(data.plan)
                   ? fmt::format(" Percentiles, shares and intervals are over {}; intervals come "
                                 "from 2000 draws of {} with replacement, those of correlations "
                                 "from 400.",
                                 units, units)
                   : " Percentiles and shares are over cases of values that were chosen, which "
                     "are no sample: without intervals but those of correlations, from 400 draws "
                     "of cases with replacement, and sites are tied only where they are equal.")));
  text += people_text(data);
  text += grade_text(data);
  text += element("p", escaped(fmt::format("Cases took {} of one "
                                           "core; seed {}, design {}. Made by Loosefit {}.",
                                           duration_text(data.core_seconds), data.plan.seed,
                                           data.plan.design, version())));
  return text;
}

std::string gallery_section(const Gallery& gallery) {
  if (!gallery.why.empty())
    return element("div", escaped("No gallery: " + gallery.why), "box warn");
  if (gallery.png.empty()) return {};
  return element("h2", "Drapes") +
         fmt::format(
             "<img alt=\"drapes of {} cases from the front, coloured by their distance from "
             "the body\" style=\"max-width:100%\" src=\"data:image/png;base64,{}\">\n",
             gallery.cases, report::base64(gallery.png));
}

/// What scores are bounds of, or why there are none; empty where all is told.
std::string bounds_text(const ModalityAnalysis& modality) {
  const std::string untold = join(modality.untold), in_part = join(modality.untold_in_part);
  std::string text;
  if (modality.rated == 0)
    text = modality.name + ": " + nothing_rated(modality) +
           (untold.empty() ? "." : ". Not told by this study: " + untold + ".");
  else if (!untold.empty())
    text = "Not told by this study, so the scores are upper bounds: " + untold + ".";
  if (!in_part.empty())
    text +=
        (text.empty() ? "" : " ") +
        ("Not told by some cases, whose scores are upper bounds among others: " + in_part + ".");
  return text;
}

}  // namespace

std::string distribution_svg(const std::vector<SiteScores>& sites, double pass) {
  constexpr double kRow = 22, kLeft = 130, kWidth = 620, kRight = 20, kTop = 10, kBottom = 34;
  const double bottom = kTop + kRow * static_cast<double>(sites.size());
  const auto at = [&](double s) {
    return kLeft + std::clamp(s, 0.0, 1.0) * (kWidth - kLeft - kRight);
  };
  std::string svg = report::svg_open(kWidth, bottom + kBottom, "scores by site");
  for (int tick = 0; tick <= 5; ++tick) {
    svg += report::svg_line(at(0.2 * tick), kTop, at(0.2 * tick), bottom, "stroke=\"#e3e7eb\"");
    svg += report::svg_text(at(0.2 * tick), bottom + 14, "middle", fixed(0.2 * tick, 1));
  }
  svg += report::svg_line(at(pass), kTop, at(pass), bottom,
                          "stroke=\"#1d6b3a\" stroke-width=\"1.5\" stroke-dasharray=\"5 4\"");
  svg += report::svg_text(at(pass), bottom + 28, "middle", "passes from here on");
  for (std::size_t i = 0; i < sites.size(); ++i) {
    const double y = kTop + kRow * (static_cast<double>(i) + 0.5);
    svg += report::svg_text(kLeft - 10, y + 4, "end", escaped(sites[i].site));
    std::vector<double> rated = sites[i].scores;
    std::erase_if(rated, [](double s) { return std::isnan(s); });
    if (rated.empty()) continue;
    svg += report::svg_line(at(quantile(rated, kRobustPeople)), y,
                            at(quantile(rated, 1 - kRobustPeople)), y,
                            "stroke=\"#2458a8\" stroke-width=\"2\"");
    const double middle = at(median(rated));
    svg += report::svg_line(middle, y - 7, middle, y + 7, "stroke=\"#2458a8\" stroke-width=\"3\"");
    for (const double s : rated)
      svg += fmt::format(
          "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"2.2\" fill=\"#2458a8\" "
          "fill-opacity=\"0.45\"/>\n",
          at(s), y);
  }
  return svg + "</svg>\n";
}

std::string study_html(const StudyAnalysis& analysis, const Gallery& gallery) {
  std::string sections;
  for (const ModalityAnalysis& modality : analysis.modalities) {
    sections += element("h2", escaped(modality.title.empty() ? modality.name : modality.title));
    if (const std::string bounds = bounds_text(modality); !bounds.empty())
      sections += element("div", escaped(metrics_in_words(bounds)), "box warn");
    sections += loose_section(analysis, modality) +
                (modality.rated > 0 ? ranking_section(analysis, modality) : "") +
                metric_section(analysis, modality) +
                sensitivity_section(modality, unit_kind(analysis.data));
  }
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>" +
         escaped(analysis.data.plan.name) + "</title>\n<style>" +
         std::string(report::kReportStyle) + "</style>\n</head>\n<body>\n" + head(analysis) +
         cautions_html(analysis.data) + sections + trouble_section(analysis.data) +
         method_section(analysis) + gallery_section(gallery) + "</body>\n</html>\n";
}

}  // namespace loosefit::study

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
#include "loosefit/report/report_style.h"
#include "loosefit/report/svg.h"
#include "loosefit/study/cautions.h"
#include "loosefit/study/loose_section.h"
#include "loosefit/study/page_numbers.h"
#include "loosefit/study/run_study.h"
#include "loosefit/study/unit_words.h"

namespace loosefit::study {
namespace {

using report::element;
using report::escaped;
using report::fixed;

/// Rows of a table of sensitivity.
constexpr std::size_t kMostSensitivities = 12;

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
              (people_axis(data.plan) < 0 && varies_by_chance(data.plan)
                   ? " Percentiles and shares are over cases; intervals, of rankings at one fit "
                     "alone and of correlations, come from draws of cases with replacement. "
                     "Elsewhere sites are tied only where they are equal."
               : varies_by_chance(data.plan)
                   ? fmt::format(" Percentiles, shares and intervals are over {}; intervals come "
                                 "from 2000 draws of {} with replacement, those of correlations "
                                 "from 400.",
                                 units, units)
                   : " Percentiles and shares are over cases of values that were chosen, which "
                     "are no sample: there are no intervals, and sites are tied only where they "
                     "are equal.")));
  text += people_text(data);
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
    svg += report::svg_line(at(quantile(rated, kRobustPeople)), y, at(robust_from_above(rated)), y,
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

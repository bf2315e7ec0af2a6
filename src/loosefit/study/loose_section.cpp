#include "loosefit/study/loose_section.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "loosefit/report/html.h"
#include "loosefit/report/plot.h"
#include "loosefit/report/svg.h"
#include "loosefit/study/page_numbers.h"
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

/// Both ends at every level: marks in the colour of the first curve.
report::Plot::Series interval_ends(const std::string& site, const HowLoose& answer,
                                   double confidence) {
  report::Plot::Series ends;
  ends.name = fmt::format("{}, {:.0f} % interval", site, 100 * confidence);
  for (const LoosePoint& p : answer.curve)
    for (const double end : {p.robust_interval.low, p.robust_interval.high}) {
      if (p.rated < 2 || std::isnan(p.robust) || std::isnan(end)) continue;
      ends.x.push_back(p.bgm);
      ends.y.push_back(std::clamp(end, kLeastDrawn, 1.0));
    }
  return ends;
}

}  // namespace

std::string loose_section(const StudyAnalysis& analysis, const ModalityAnalysis& modality) {
  if (modality.how_loose.empty()) return "";
  const StudyData& data = analysis.data;
  report::Plot plot;
  plot.x_label = "body-garment mobility (" + data.plan.looseness + ")";
  const UnitKind kind = unit_kind(data);
  plot.y_label = kind == UnitKind::people
                     ? "score that 95 % of people reach (drawn from -1 on)"
                     : "5th percentile over " + column_name(kind) + " (drawn from -1 on)";
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
  if (!plot.series.empty())
    for (const auto& [site, answer] : sites)
      if (site == plot.series.front().name)
        if (auto ends = interval_ends(site, *answer, analysis.options.confidence); !ends.x.empty())
          plot.series.push_back(std::move(ends));
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

}  // namespace loosefit::study

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "loosefit/report/html.h"
#include "loosefit/report/map_texts.h"
#include "loosefit/report/plot.h"
#include "loosefit/report/sections.h"

namespace loosefit::report {
namespace {

/// Greatest of a metric over donnings; NaN where none has it.
double worst(const pipeline::CaseLine& line, const std::string& metric) {
  double most = std::numeric_limits<double>::quiet_NaN();
  for (const auto& of_donning : line.metrics)
    if (const auto at = of_donning.find(metric); at != of_donning.end())
      most = std::isnan(most) ? at->second : std::max(most, at->second);
  return most;
}

double least(const pipeline::CaseLine& line, const std::string& metric) {
  double found = std::numeric_limits<double>::quiet_NaN();
  for (const auto& of_donning : line.metrics)
    if (const auto at = of_donning.find(metric); at != of_donning.end())
      found = std::isnan(found) ? at->second : std::min(found, at->second);
  return found;
}

std::string percent(double share, int decimals = 1) {
  return std::isfinite(share) ? fixed(100 * share, decimals) : "–";
}

/// "stretch 0.73, lead fails", the scorecards of a line in short.
std::string verdict_text(const pipeline::CaseLine& line) {
  std::string text;
  for (const pipeline::CaseLine::Verdict& v : line.verdicts) {
    text += (text.empty() ? "" : ", ") + v.scorecard + " ";
    text += v.score.q ? fixed(*v.score.q, 2) : "not rated";
  }
  return text.empty() ? "–" : text;
}

std::string line_table(const pipeline::CaseResult& result) {
  Table table({"Line", "as cut [mm]", "as worn [mm]", "elongation [%]", "greatest [%]",
               "of any part [%]", "swing [%]", "swing [mm]", "slack [%]", "contact [%]",
               "donnings [%]", "bend radius [mm]", "tension [N]", "score"});
  table.make_sortable("lines");
  for (const auto& [column, term] : {std::pair(3, "line-elongation"),
                                     {4, "line-elongation"},
                                     {5, "line-elongation"},
                                     {6, "line-swing"},
                                     {7, "line-swing"},
                                     {8, "line-slack"},
                                     {9, "line-contact"},
                                     {10, "line-donnings"},
                                     {11, "line-bend"},
                                     {12, "line-tension"},
                                     {13, "line-score"}})
    table.define(column, term);
  for (const pipeline::CaseLine& line : result.lines) {
    const bool worn = !line.states.empty();
    const double tension = worst(line, "line_force_N");
    table.add(
        {spaced(line.name), fixed(1e3 * line.course.length, 0),
         worn ? fixed(1e3 * line.states.front().length, 0) : "–",
         worn ? percent(line.states.front().elongation) : "–",
         percent(worst(line, "line_elongation_most")), percent(worst(line, "line_part_elongation")),
         percent(worst(line, "line_swing")), number(worst(line, "line_swing_mm"), 3),
         percent(worst(line, "line_slack"), 0), percent(least(line, "line_contact"), 0),
         percent(worst(line, "line_donning_shift"), 2),
         number(least(line, "line_bend_radius_mm"), 3), tension > 0 ? fixed(tension, 2) : "–",
         verdict_text(line)},
        {"line", spaced(line.name)});
  }
  return table.html();
}

/// Why it scores as it does.
std::string reasons(const pipeline::CaseResult& result) {
  std::string list;
  for (const pipeline::CaseLine& line : result.lines)
    for (const pipeline::CaseLine::Verdict& v : line.verdicts)
      list += element(
          "li", escaped(fmt::format("{}, {}: {}", spaced(line.name), v.scorecard, v.score.reason)));
  for (const placement::UncoveredSite& line : result.lines_left_out)
    list += element("li", escaped(spaced(line.name) + " is left out: " + line.why));
  return list.empty() ? list : element("ul", list);
}

/// A route against others, and why not the shortest way.
std::string route_text(const pipeline::CaseLine& line) {
  if (line.routes.empty() || !line.shortest) return {};
  Table table({"Way of " + spaced(line.name), "as cut [mm]", "greatest strain [%]",
               "mean of the worst [%]", "bend radius [mm]", "slip [mm]", "seams crossed"});
  table.define(2, "line-strain");
  const auto add = [&](const std::string& name, const lines::Route& route) {
    table.add({name, fixed(1e3 * route.course.length, 0), percent(route.strain),
               percent(route.mean_strain, 2), number(1e3 * route.bend_radius, 3),
               number(1e3 * route.slip, 3), std::to_string(route.seams)});
  };
  for (std::size_t r = 0; r < line.routes.size(); ++r)
    add(r == 0 ? "taken" : "alternative " + std::to_string(r), line.routes[r]);
  add("shortest, not taken", *line.shortest);
  const lines::Route &best = line.routes.front(), &straight = *line.shortest;
  const double longer = best.course.length / straight.course.length - 1;
  // In the mean where the greatest strains read alike.
  const bool alike = percent(straight.strain) == percent(best.strain);
  const std::string why =
      longer < 5e-4 ? "The shortest way is the one that is stretched least."
                    : fmt::format(
                          "The shortest way is {} % shorter, but would be stretched {} {} % "
                          "where this one is by {} %.",
                          percent(longer / (1 + longer)), alike ? "in the mean by" : "by up to",
                          percent(alike ? straight.mean_strain : straight.strain, 2),
                          percent(alike ? best.mean_strain : best.strain, 2));
  return table.html() + element("p", escaped(why));
}

std::string sensitivity_text(const pipeline::CaseLine& line, const lines::Sensitivity& s) {
  Plot plot{spaced(line.name) + " and " + spaced(s.joint),
            spaced(s.joint) + " [degrees]",
            "signal [%]",
            false,
            false,
            {}};
  plot.height = 300;
  Plot::Series mean{"mean", {}, {}, true}, each{"each donning", {}, {}};
  for (const lines::CurvePoint& p : s.curve) {
    mean.x.push_back(p.degrees), mean.y.push_back(100 * p.mean);
    for (const double signal : p.signals)
      each.x.push_back(p.degrees), each.y.push_back(100 * signal);
  }
  plot.series = {mean, each};
  std::string words = fmt::format("{}: {} % per degree", spaced(s.joint), number(100 * s.gain, 2));
  words += s.monotone_to > s.monotone_from
               ? fmt::format("; one signal is one angle from {} to {} degrees",
                             number(s.monotone_from, 3), number(s.monotone_to, 3))
               : "; nowhere is one signal one angle";
  if (std::isfinite(s.angle_error))
    words += fmt::format("; from one donning to another the angle is known to {} degrees",
                         number(s.angle_error, 2));
  for (const lines::CrossEffect& c : s.cross)
    words += fmt::format(
        "; {} changes the signal by {} %{}", spaced(c.posture), number(100 * c.change, 2),
        std::isfinite(c.degrees) ? fmt::format(", as {} degrees would", number(c.degrees, 2)) : "");
  return svg_plot(plot) + element("p", escaped(words + "."));
}

}  // namespace

std::string line_section(const pipeline::CaseResult& result) {
  if (result.lines.empty() && result.lines_left_out.empty()) return {};
  std::string html = element("h2", "Lines: stretch sensors and leads");
  if (!result.lines.empty()) html += line_table(result);
  html += reasons(result);
  for (const pipeline::CaseLine& line : result.lines) {
    html += route_text(line);
    for (const lines::Sensitivity& s : line.sensitivities) html += sensitivity_text(line, s);
  }
  return html +
         element("p",
                 "Elongations are against the sensor's own length, greatest and least over all "
                 "postures and donnings that count. The pattern with all lines at 1:1 is "
                 "lines.svg, for cutters lines.dxf, as cables of a scenario lines.toml.");
}

}  // namespace loosefit::report

#include "loosefit/validate/validation_page.h"

#include <fmt/format.h>

#include <cmath>

#include "loosefit/base/version.h"
#include "loosefit/report/html.h"
#include "loosefit/report/plot.h"
#include "loosefit/report/report_style.h"
#include "loosefit/validate/solver_settings.h"
#include "loosefit/validate/validation_table.h"

namespace loosefit::validate {
namespace {

constexpr const char* kPageStyle = R"css(
.plots { display: grid; grid-template-columns: repeat(auto-fit, minmax(330px, 1fr)); gap: .8rem;
  margin: .8rem 0; }
.plots figure { padding: .4rem; }
td.verdict-miss { color: var(--bad); font-weight: 700; }
td.verdict-pass { color: var(--good); }
td.verdict-known { color: var(--warn); font-weight: 700; }
tbody th:first-child { white-space: normal; }
td.mesh { white-space: normal; min-width: 13rem; text-align: left; padding-left: .7rem; }
.tag { font-size: .85rem; font-weight: 600; border-radius: 3px; padding: .1rem .5rem; }
)css";

/// One line per benchmark: the figure that comes closest to its gate, or misses it by most.
const Finding* worst_of(const BenchmarkOutcome& o) {
  const Finding* worst = nullptr;
  double most = -1;
  for (const Finding& f : o.result.findings) {
    if (f.gate == Finding::Gate::reported) continue;
    const double share = f.share_of_gate();
    if (share > most || !worst) {
      most = share;
      worst = &f;
    }
  }
  return worst;
}

std::string cell(Verdict verdict) {
  const char* look = !is_as_stated(verdict)           ? "verdict-miss"
                     : verdict == Verdict::known_miss ? "verdict-known"
                                                      : "verdict-pass";
  return "<td class=\"" + std::string(look) + "\">" + name(verdict) + "</td>";
}

std::string anchor(const std::string& id) { return "#" + id; }

std::string overview(const Validation& validation) {
  std::string rows;
  for (const auto& o : validation.outcomes) {
    const Finding* worst = worst_of(o);
    rows += "<tr><th scope=\"row\"><a href=\"" + report::escaped(anchor(o.id)) + "\">" +
            report::escaped(o.id) + "</a> " + report::escaped(o.title) + "</th><td>" +
            std::to_string(o.result.findings.size()) + "</td><td>" +
            report::escaped(worst ? error_text(*worst) : "–") + "</td><td>" +
            report::escaped(worst ? gate_text(*worst) : "–") + "</td>" + cell(o.verdict()) +
            "<td>" + report::fixed(o.seconds, 1) + "</td></tr>\n";
  }
  return "<div class=\"scroll\"><table>\n<thead><tr><th scope=\"col\">benchmark</th><th "
         "scope=\"col\">figures</th><th scope=\"col\">error nearest its gate</th><th "
         "scope=\"col\">gate</th><th scope=\"col\"></th><th scope=\"col\">seconds</th></tr></thead>"
         "\n<tbody>\n" +
         rows + "</tbody></table></div>\n";
}

std::string findings_table(const BenchmarkOutcome& o) {
  std::string rows;
  for (const Finding& f : o.result.findings) {
    const std::string unit = f.unit.empty() ? "" : " [" + f.unit + "]";
    rows += "<tr><th scope=\"row\">" + report::escaped(f.what + unit) + "</th><td>" +
            report::number(f.expected, 6) + "</td><td>" + report::number(f.obtained, 6) +
            "</td><td>" + report::escaped(error_text(f)) + "</td><td>" +
            report::escaped(gate_text(f)) + "</td>" + cell(f.verdict()) + "<td class=\"mesh\">" +
            report::escaped(f.mesh) + "</td></tr>\n";
  }
  return "<div class=\"scroll\"><table>\n<thead><tr><th scope=\"col\">figure</th><th "
         "scope=\"col\">expected</th><th scope=\"col\">obtained</th><th "
         "scope=\"col\">error</th><th "
         "scope=\"col\">gate</th><th scope=\"col\"></th><th scope=\"col\">mesh</th></tr></thead>\n"
         "<tbody>\n" +
         rows + "</tbody></table></div>\n";
}

std::string section(const BenchmarkOutcome& o) {
  const Verdict verdict = o.verdict();
  std::string html = "<h2 id=\"" + report::escaped(o.id) + "\">" +
                     report::escaped(o.id + " " + o.title) + " <span class=\"tag " +
                     (!is_as_stated(verdict)           ? "bad"
                      : verdict == Verdict::known_miss ? "warn"
                                                       : "good") +
                     "\">" + name(verdict) + "</span></h2>\n";
  html += report::element("p", "Reference: " + report::escaped(o.reference), "lead");
  if (!o.error.empty())
    html += report::element("div", "<strong>Not carried out.</strong> " + report::escaped(o.error),
                            "box bad");
  std::string plots;
  for (const report::Plot& plot : o.result.plots) {
    const std::string drawn = report::svg_plot(plot);
    if (!drawn.empty())
      plots += report::element("figure",
                               drawn + report::element("figcaption", report::escaped(plot.title)));
  }
  if (!plots.empty()) html += report::element("div", plots, "plots");
  if (!o.result.findings.empty()) html += findings_table(o);
  for (const Finding& f : o.result.findings)
    if (f.known_miss) html += report::element("p", report::escaped(known_miss_text(f)), "known");
  for (const std::string& note : o.result.notes)
    html += report::element("p", report::escaped(note));
  return html;
}

std::string headline(const Validation& validation) {
  const char* effort = validation.effort == Effort::quick ? "Quick subset" : "All benchmarks";
  return report::element("h1", "Loosefit against known solutions") +
         report::element(
             "p",
             "Each benchmark is a piece of cloth whose behaviour is known exactly, from "
             "beam, plate and membrane theory or from measurements. It is meshed, sewn and "
             "weighed like a garment and goes through the same energies and the same solver. "
             "The gates were set before the figures were computed.",
             "lead") +
         report::element("div",
                         report::element("strong", report::escaped(verdict_line(validation))) +
                             "<br>" + effort + ", " + report::fixed(validation.seconds, 0) + " s.",
                         std::string("box ") + (validation.as_stated() ? "good" : "bad"));
}

std::string settings() {
  std::string list;
  for (const auto& [what, how] : solver_settings())
    list +=
        report::element("dt", report::escaped(what)) + report::element("dd", report::escaped(how));
  return report::element("h2", "Settings, the same for all benchmarks") +
         report::element("dl", list);
}

std::string reading_aid() {
  return report::element("h2", "How to read the tables") +
         report::element(
             "dl",
             report::element("dt", "expected") +
                 report::element("dd",
                                 "the figure of the reference that stands below the heading") +
                 report::element("dt", "obtained") +
                 report::element("dd", "the figure of this program") +
                 report::element("dt", "error and gate") +
                 report::element(
                     "dd",
                     "in percent: difference over the expected figure; with a unit: the "
                     "difference itself. The gate is the largest error allowed. "
                     "“reported” has no gate. A “known miss” misses its gate by no more than is "
                     "stated under the table, where the reason stands as far as it is known; an "
                     "“unexpected pass” is stated to miss and does not, so the statement is out of "
                     "date.") +
                 report::element("dt", "mesh") +
                 report::element("dd",
                                 "mean edge and number of triangles; meshes are irregular, as "
                                 "those of garments are"));
}

}  // namespace

std::string validation_html(const Validation& validation) {
  std::string sections;
  for (const auto& outcome : validation.outcomes) sections += section(outcome);
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
         "<title>Loosefit validation</title>\n<style>" +
         std::string(report::kReportStyle) + kPageStyle + "</style>\n</head>\n<body>\n" +
         headline(validation) + overview(validation) + sections + settings() + reading_aid() +
         report::element(
             "p", "Made by Loosefit " + report::escaped(version()) + ": loosefit validate -o DIR",
             "lead") +
         "</body>\n</html>\n";
}

}  // namespace loosefit::validate

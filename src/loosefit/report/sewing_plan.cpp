#include "loosefit/report/sewing_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "loosefit/io/pattern_svg.h"
#include "loosefit/pattern/outline.h"
#include "loosefit/report/lines_plan.h"
#include "loosefit/report/sewing_labels.h"
#include "loosefit/report/sewing_marks.h"

namespace loosefit::report {
namespace {

std::string millimetres(double metres) { return fmt::format("{:.0f}", 1e3 * metres); }

std::string sensor_words(const placement::FootprintShape& shape) {
  switch (shape.kind) {
    case placement::FootprintShape::Kind::disc:
      return fmt::format("disc of {} mm", millimetres(2 * shape.radius));
    case placement::FootprintShape::Kind::rectangle:
      return fmt::format("{} x {} mm", millimetres(shape.size.x()), millimetres(shape.size.y()));
    case placement::FootprintShape::Kind::line:
      return fmt::format("line of {} mm", millimetres(shape.length));
    case placement::FootprintShape::Kind::girth:
      break;
  }
  return "line round the body";
}

bool shared(const placement::RankedSite& site, const placement::Ranking& ranking) {
  return std::count_if(
             ranking.sites.begin(), ranking.sites.end(),
             [&](const placement::RankedSite& other) { return other.rank == site.rank; }) > 1;
}

/// "2= best_3", as the table on the terminal has it.
std::string numbered(const placement::RankedSite& site, const placement::Ranking& ranking) {
  return fmt::format("{}{} {}", site.rank, shared(site, ranking) ? "=" : "", site.name);
}

std::string score_words(const placement::RankedSite& site) {
  std::string words = fmt::format("score {:.2f}", site.score.robust);
  if (site.robust_interval)
    words +=
        fmt::format(" ({:.2f} to {:.2f})", site.robust_interval->low, site.robust_interval->high);
  return words;
}

std::string tolerance_words(const placement::RankedPlace& place) {
  if (!place.tolerance) return {};
  return fmt::format("±{:.0f} mm along, ±{:.0f} mm around", 1e3 * place.tolerance->along,
                     1e3 * place.tolerance->around);
}

std::string site_line(const placement::RankingTable& table, const placement::RankedSite& site) {
  const placement::RankedPlace& place = table.places[site.index];
  std::string line = fmt::format(
      "{}: {} at u {:.1f}, v {:.1f} mm, axis {:.0f}° from the grain (counter-clockwise), {}",
      numbered(site, table.ranking), place.panel, 1e3 * place.at.x(), 1e3 * place.at.y(),
      degrees(std::remainder(place.angle, 2 * kPi)) + 0.0, sensor_words(place.shape));
  if (place.anatomy) line += ", over " + place.anatomy->str();
  if (place.tolerance) line += ", tolerance " + tolerance_words(place);
  line += ", " + score_words(site);
  if (site.score.robust < table.scorecard.pass) line += ", does not pass";
  return line + ": " + site.score.reason;
}

bool recommended(const placement::RankedSite& site) {
  return site.score.rated() && site.score.robust > 0;
}

std::vector<Vec2> outline_on_sheet(const pattern::Panel& panel, const io::PanelOnSheet& sheet) {
  std::vector<Vec2> points;
  for (const Vec2& p : pattern::outline_polygon(panel)) points.push_back(sheet.at(p));
  return points;
}

std::string panel_marks(const placement::RankingTable& table, const pattern::Pattern& pattern,
                        int panel, const io::PanelOnSheet& sheet) {
  const pattern::Panel& piece = pattern.panels[panel];
  std::set<int> sewn;
  for (const pattern::Stitch& stitch : pattern.stitches)
    for (const pattern::Stitch::Side& side : {stitch.first, stitch.second})
      if (side.panel == panel) sewn.insert(side.edge);
  std::string out = forbidden_marks(piece, sewn, table.constraints, sheet);
  SewingLabels labels(outline_on_sheet(piece, sheet));
  std::vector<const placement::RankedSite*> sites;
  for (const placement::RankedSite& site : table.ranking.sites) {
    const placement::RankedPlace& place = table.places[site.index];
    if (place.shape.kind == placement::FootprintShape::Kind::girth && recommended(site))
      out += line_marks(place, piece.name, sheet);
    if (place.panel != piece.name) continue;
    if (!recommended(site)) {
      out += failing_mark(place, site.name, sheet);
      labels.keep_off({sheet.at(place.at), sheet.at(place.at) + Vec2(12, 0)});
      continue;
    }
    out += sensor_marks(place, piece, sheet, site.score.robust >= table.scorecard.pass);
    labels.keep_off(marked_points(place, piece, sheet));
    sites.push_back(&site);
  }
  for (const placement::RankedSite* site : sites) {
    const placement::RankedPlace& place = table.places[site->index];
    out +=
        labels.place(sheet.at(place.at), 1e3 * placement::outer_radius(place.shape),
                     {numbered(*site, table.ranking), score_words(*site), tolerance_words(place)});
  }
  return out;
}

}  // namespace

std::string sewing_plan_svg(const placement::RankingTable& table, const pattern::Pattern& pattern,
                            const pipeline::CaseResult* lines) {
  io::SheetMarks marks;
  marks.title = "Where to sew: " + table.scorecard.title;
  marks.words =
      "print at 100 %: the control square must measure 100 mm; outside of the cloth, no seam "
      "allowance; equal numbers are sewn together";
  marks.over_panel = [&](int panel, const io::PanelOnSheet& sheet) {
    return (lines ? lines_on_sheet(*lines, panel, sheet) : std::string()) +
           panel_marks(table, pattern, panel, sheet);
  };
  marks.lines = {
      "outline: the sensor (green passes, orange does not); arrow: its axis; dashed ellipse: its "
      "centre may lie there and keeps 90 % of the score",
      fmt::format("thin lines: from the centre to two edges of the piece; shaded: nearer than {:g} "
                  "mm to a seam, {:g} mm to a hem or opening, or kept free; grey cross: fails, or "
                  "is not rated",
                  1e3 * table.constraints.seam_clearance, 1e3 * table.constraints.edge_clearance)};
  for (const placement::RankedSite& site : table.ranking.sites)
    if (recommended(site)) marks.lines.push_back(site_line(table, site));
  if (marks.lines.size() == 2) marks.lines.push_back("no place is recommended");
  if (lines)
    for (const std::string& sentence : line_sentences(*lines)) marks.lines.push_back(sentence);
  if (!table.scorecard.left_out.empty()) {
    std::string words = "scores are upper bounds, not looked at:";
    for (const std::string& metric : table.scorecard.left_out)
      words += " " + placement::metric_with_need(metric);
    marks.lines.push_back(words);
  }
  return io::pattern_svg(pattern, marks);
}

}  // namespace loosefit::report

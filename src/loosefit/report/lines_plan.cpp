#include "loosefit/report/lines_plan.h"

#include <fmt/format.h>

#include <cmath>

#include "loosefit/io/pattern_svg.h"
#include "loosefit/render/line_mark.h"
#include "loosefit/report/sewing_marks.h"

namespace loosefit::report {
namespace {

std::string colour_of(std::size_t line) {
  const render::Rgb c = render::line_colour(line);
  return fmt::format("#{:02x}{:02x}{:02x}", c[0], c[1], c[2]);
}

std::string polyline(const lines::PanelStretch& stretch, const io::PanelOnSheet& sheet,
                     const std::string& colour, bool dashed) {
  std::string points;
  for (const Vec2& p : stretch.points) {
    const Vec2 at = sheet.at(p);
    points += fmt::format("{:.2f},{:.2f} ", at.x(), at.y());
  }
  return fmt::format(
      "    <polyline class=\"{}\" points=\"{}\" fill=\"none\" stroke=\"{}\" "
      "stroke-width=\"{}\"{}/>\n",
      dashed ? "other-route" : "sensor-line", points, colour, dashed ? 0.6 : 1.2,
      dashed ? " stroke-dasharray=\"4 3\"" : "");
}

/// Two strokes at the end of a line.
std::string arrow(const Vec2& before, const Vec2& end, const std::string& colour) {
  const Vec2 back = (before - end).normalized() * 5, aside(-0.4 * back.y(), 0.4 * back.x());
  const Vec2 a = end + back + aside, b = end + back - aside;
  return fmt::format(
      "    <path d=\"M {:.2f} {:.2f} L {:.2f} {:.2f} L {:.2f} {:.2f}\" fill=\"none\" stroke=\"{}\" "
      "stroke-width=\"1.2\"/>\n",
      a.x(), a.y(), end.x(), end.y(), b.x(), b.y(), colour);
}

std::string line_on(const pipeline::CaseLine& line, const garment::Garment& mesh,
                    const std::string& panel, const io::PanelOnSheet& sheet,
                    const std::string& colour) {
  std::string out;
  for (std::size_t r = 1; r < line.routes.size(); ++r)
    for (const lines::PanelStretch& stretch : lines::stretches(mesh, line.routes[r].course))
      if (mesh.panel_names[stretch.panel] == panel) out += polyline(stretch, sheet, colour, true);
  const std::vector<lines::PanelStretch> way = lines::stretches(mesh, line.course);
  for (std::size_t i = 0; i < way.size(); ++i) {
    if (mesh.panel_names[way[i].panel] != panel) continue;
    const std::vector<Vec2>& points = way[i].points;
    out += polyline(way[i], sheet, colour, false);
    if (i == 0) {
      const Vec2 begin = sheet.at(points.front());
      out += fmt::format("    <circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"1.8\" fill=\"{}\"/>\n",
                         begin.x(), begin.y(), colour);
      out += rimmed_text(begin + Vec2(3, -2), 4, line.name, "start", colour.c_str());
    }
    if (i + 1 == way.size() && points.size() > 1)
      out += arrow(sheet.at(points[points.size() - 2]), sheet.at(points.back()), colour);
  }
  return out;
}

std::string words_of(const pipeline::CaseLine& line) {
  std::string words = fmt::format("{}: {:.0f} mm as cut", line.name, 1e3 * line.course.length);
  if (!line.states.empty())
    words += fmt::format(", {:.0f} mm as worn", 1e3 * line.states.front().length);
  if (line.routes.empty() || !line.shortest) return words;
  const lines::Route& best = line.routes.front();
  return words +
         fmt::format(
             "; stretched by at most {:.1f} % ({:.1f} % in the mean), on the shortest way of "
             "{:.0f} mm by {:.1f} % ({:.1f} %); dashed: {} more",
             100 * best.strain, 100 * best.mean_strain, 1e3 * line.shortest->course.length,
             100 * line.shortest->strain, 100 * line.shortest->mean_strain, line.routes.size() - 1);
}

}  // namespace

std::string lines_on_sheet(const pipeline::CaseResult& result, int panel,
                           const io::PanelOnSheet& sheet) {
  const std::string& name = result.studied().pattern.pattern.panels[panel].name;
  std::string out;
  for (std::size_t i = 0; i < result.lines.size(); ++i)
    out += line_on(result.lines[i], result.studied().mesh(), name, sheet, colour_of(i));
  return out;
}

std::vector<std::string> line_sentences(const pipeline::CaseResult& result) {
  std::vector<std::string> sentences;
  for (const pipeline::CaseLine& line : result.lines) sentences.push_back(words_of(line));
  return sentences;
}

std::string lines_plan_svg(const pipeline::CaseResult& result) {
  io::SheetMarks marks;
  marks.title = "Where lines run";
  marks.words =
      "print at 100 %: the control square must measure 100 mm; outside of the cloth, no seam "
      "allowance; equal numbers are sewn together";
  marks.over_panel = [&](int panel, const io::PanelOnSheet& sheet) {
    return lines_on_sheet(result, panel, sheet);
  };
  marks.lines = line_sentences(result);
  return io::pattern_svg(result.studied().pattern.pattern, marks);
}

}  // namespace loosefit::report

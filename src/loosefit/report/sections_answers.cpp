#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "loosefit/geometry/triangle_mesh.h"
#include "loosefit/pattern/outline.h"
#include "loosefit/render/garment_lines.h"
#include "loosefit/report/html.h"
#include "loosefit/report/sections.h"
#include "loosefit/report/svg.h"

namespace loosefit::report {
namespace {

constexpr double kSide = 150, kRim = 8;  // of the drawing [px]

/// The piece of the pattern with the sensor on it; empty where there is no such piece.
std::string piece_with_sensor(const pattern::Pattern& pattern, const pipeline::Answer& answer) {
  const int index = pattern.find_panel(answer.panel);
  if (index < 0) return {};
  const std::vector<Vec2> outline = pattern::outline_polygon(pattern.panels[index]);
  Vec2 low = outline.front(), high = outline.front();
  for (const Vec2& p : outline) low = low.cwiseMin(p), high = high.cwiseMax(p);
  const double scale = (kSide - 2 * kRim) / (high - low).maxCoeff();
  const Vec2 size = scale * (high - low) + Vec2::Constant(2 * kRim);
  const auto on_sheet = [&](const Vec2& p) {
    return Vec2(kRim + scale * (p.x() - low.x()), size.y() - kRim - scale * (p.y() - low.y()));
  };
  std::string points;
  for (const Vec2& p : outline)
    points += fmt::format("{:.1f},{:.1f} ", on_sheet(p).x(), on_sheet(p).y());
  const Vec2 at = on_sheet(answer.at);
  const Vec2 along = placement::axis_in_pattern(answer.angle);
  // The smallest sensors are drawn larger than they are, to be seen.
  const double radius = std::max(3.5, scale * placement::outer_radius(answer.shape));
  const Vec2 tip = at + (radius + 9) * Vec2(along.x(), -along.y());
  return svg_open(size.x(), size.y(), "Piece " + answer.panel + " with the sensor") +
         "<polygon class=\"piece\" points=\"" + points + "\"/>" +
         fmt::format("<circle class=\"spot\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\"/>", at.x(),
                     at.y(), radius) +
         svg_line(at.x(), at.y(), tip.x(), tip.y(), "class=\"axis\"") + "</svg>\n";
}

/// The worn garment as seams and edges seen from the side on which the sensor is; empty where that
/// is not a place of this case.
std::string worn_with_sensor(const pipeline::CaseResult& result, const pipeline::Answer& answer) {
  const garment::Garment& mesh = result.studied().mesh();
  const std::vector<Vec3>& x = result.studied().drape.positions;
  const int panel = result.studied().pattern.pattern.find_panel(answer.panel);
  if (panel < 0 || x.empty()) return {};
  // Where the place of the pattern has come to lie: the middle of the nearest triangle.
  Vec3 at = Vec3::Zero();
  Vec3 outwards = Vec3::UnitY();
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (mesh.panel_names[mesh.triangle_panel[t]] != answer.panel) continue;
    const auto& uv = mesh.triangle_uv[t];
    const double off = ((uv[0] + uv[1] + uv[2]) / 3 - answer.at).norm();
    if (off >= nearest) continue;
    nearest = off;
    const Triangle& c = mesh.triangles[t];
    at = (x[c[0]] + x[c[1]] + x[c[2]]) / 3;
    outwards = (x[c[1]] - x[c[0]]).cross(x[c[2]] - x[c[0]]);
  }
  const double side = outwards.y() > 0 ? 1 : -1;  // 1: seen from behind
  Vec3 low = x.front(), high = x.front();
  for (const Vec3& p : x) low = low.cwiseMin(p), high = high.cwiseMax(p);
  const Vec2 extent(high.x() - low.x(), high.z() - low.z());
  const double scale = (kSide - 2 * kRim) / extent.maxCoeff();
  const Vec2 size = scale * extent + Vec2::Constant(2 * kRim);
  const auto on_sheet = [&](const Vec3& p) {
    const double across = side < 0 ? p.x() - low.x() : high.x() - p.x();
    return Vec2(kRim + scale * across, size.y() - kRim - scale * (p.z() - low.z()));
  };
  const std::vector<Vec3> normals = geometry::vertex_normals(x, mesh.triangles);
  std::string path;
  const render::GarmentLines lines = render::garment_lines(mesh);
  for (const auto* some : {&lines.boundary, &lines.seams})
    for (const auto& [from, to] : *some) {
      if (side * normals[from].y() < -0.1) continue;  // on the far side
      const Vec2 a = on_sheet(x[from]), b = on_sheet(x[to]);
      path += fmt::format("M{:.1f} {:.1f}L{:.1f} {:.1f}", a.x(), a.y(), b.x(), b.y());
    }
  const Vec2 spot = on_sheet(at);
  return svg_open(size.x(), size.y(),
                  std::string("The garment from ") + (side > 0 ? "behind" : "the front") +
                      " with the sensor") +
         "<path class=\"seam\" d=\"" + path + "\"/>" +
         fmt::format("<circle class=\"spot\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"4.5\"/>", spot.x(),
                     spot.y()) +
         "</svg>\n";
}

std::string link(const std::string& file) {
  const bool plan = file.starts_with("sewing-plan");
  std::string words = plan ? "sewing plan" : file.starts_with("lines") ? "line plan" : "pattern";
  words += file.ends_with(".svg") ? " (SVG 1:1)" : file.ends_with(".dxf") ? " (DXF)" : " (JSON)";
  return "<a href=\"" + escaped(file) + "\">" + escaped(words) + "</a>";
}

std::string card(const pipeline::CaseResult& result, const pipeline::Answer& answer) {
  const char* kind = !answer.passes ? "warn" : *answer.passes ? "good" : "bad";
  const char* word = !answer.passes ? "undecided" : *answer.passes ? "passes" : "does not pass";
  std::string text = element("h2", "<span class=\"verdict " + std::string(kind) + "\">" + word +
                                       "</span>" + escaped(answer.sensor));
  text +=
      element("p", element("strong", escaped(answer.place)) + " " + escaped(answer.expectation));
  std::string rest = answer.verdict;
  for (const std::string& more : {answer.limit, answer.need})
    if (!more.empty()) rest += " " + more;
  text += element("p", escaped(rest));
  if (!answer.pass_mark.empty()) text += element("p", escaped(answer.pass_mark), "soft");
  std::string links;
  for (const std::string& file : answer.files) links += (links.empty() ? "" : " · ") + link(file);
  if (!links.empty()) text += element("p", "To sew by: " + links, "soft");
  const std::string pictures = worn_with_sensor(result, answer) +
                               piece_with_sensor(result.studied().pattern.pattern, answer);
  return "<article class=\"answer\">" +
         (pictures.empty() ? "" : element("div", pictures, "places")) + element("div", text) +
         "</article>\n";
}

}  // namespace

std::string answer_section(const pipeline::CaseResult& result) {
  if (result.answers.empty()) return {};
  std::string cards;
  for (const pipeline::Answer& answer : result.answers) cards += card(result, answer);
  std::string html = "<section class=\"answers\" aria-label=\"Where to sew, and what to expect\">" +
                     cards + "</section>\n";
  if (!result.answers.front().asked)
    html += element("p",
                    "No sensor was asked for, so these are the usual ones at the best of the known "
                    "places. loosefit rank DIR -m NAME --best 3 searches the whole garment and "
                    "draws a sewing plan.",
                    "soft");
  return html;
}

}  // namespace loosefit::report

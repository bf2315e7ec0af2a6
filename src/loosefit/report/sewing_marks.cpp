#include "loosefit/report/sewing_marks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "loosefit/pattern/outline.h"

namespace loosefit::report {
namespace {

using Kind = placement::FootprintShape::Kind;

constexpr const char* kPass = "#0a7d3c";
constexpr const char* kShort = "#b35900";
constexpr int kEdgePieces = 200;
constexpr double kArrow = 12;  // beyond the outline [mm]

std::string point(const Vec2& p) { return fmt::format("{:.2f} {:.2f}", p.x(), p.y()); }

std::string path(const std::string& kind, const std::string& data, const std::string& style) {
  return fmt::format("    <path class=\"{}\" d=\"{}\" {}/>\n", kind, data, style);
}

std::string polyline(const std::vector<Vec2>& points, const io::PanelOnSheet& sheet) {
  std::string data;
  for (const Vec2& p : points) data += (data.empty() ? "M " : " L ") + point(sheet.at(p));
  return data;
}

/// Extent of the sensor along its axis from its centre [mm].
double reach(const placement::FootprintShape& shape) {
  switch (shape.kind) {
    case Kind::disc:
      return 1e3 * shape.radius;
    case Kind::rectangle:
      return 500 * shape.size.y();
    case Kind::line:
      return 500 * shape.length;
    case Kind::girth:
      break;
  }
  return 0;
}

std::string outline(const placement::RankedPlace& place, const io::PanelOnSheet& sheet,
                    const char* colour) {
  const std::string style =
      fmt::format("fill=\"{0}\" fill-opacity=\"0.15\" stroke=\"{0}\" stroke-width=\"0.8\"", colour);
  const Vec2 along = placement::axis_in_pattern(place.angle), across(along.y(), -along.x());
  if (place.shape.kind == Kind::disc) {
    const Vec2 at = sheet.at(place.at);
    return fmt::format(
        "    <circle class=\"sensor\" cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{:.2f}\" {}/>\n", at.x(),
        at.y(), 1e3 * place.shape.radius, style);
  }
  if (place.shape.kind == Kind::rectangle) {
    const Vec2 a = place.shape.size.x() / 2 * across, b = place.shape.size.y() / 2 * along;
    return path(
        "sensor",
        polyline({place.at - a - b, place.at + a - b, place.at + a + b, place.at - a + b}, sheet) +
            " Z",
        style);
  }
  if (place.shape.kind == Kind::line) {
    const Vec2 half = place.shape.length / 2 * along;
    return path("sensor", polyline({place.at - half, place.at + half}, sheet),
                fmt::format("fill=\"none\" stroke=\"{}\" stroke-width=\"1.6\"", colour));
  }
  return {};
}

std::string axis(const placement::RankedPlace& place, const io::PanelOnSheet& sheet,
                 const char* colour) {
  const Vec2 along = placement::axis_in_pattern(place.angle), across(along.y(), -along.x());
  const double length = 1e-3 * (reach(place.shape) + kArrow);
  const Vec2 tip = place.at + length * along, back = tip - 0.005 * along;
  return path("axis",
              polyline({place.at, tip}, sheet) + " " +
                  polyline({back + 0.0025 * across, tip, back - 0.0025 * across}, sheet),
              fmt::format("fill=\"none\" stroke=\"{}\" stroke-width=\"0.8\"", colour));
}

std::string ellipse(const placement::RankedPlace& place, const io::PanelOnSheet& sheet,
                    const char* colour) {
  if (!place.tolerance) return {};
  const Vec2 at = sheet.at(place.at), along = place.tolerance->direction;
  // The sheet's y runs downwards, and so does its sense of rotation.
  return fmt::format(
      "    <ellipse class=\"tolerance\" cx=\"{0:.2f}\" cy=\"{1:.2f}\" rx=\"{2:.2f}\" "
      "ry=\"{3:.2f}\" transform=\"rotate({4:.2f} {0:.2f} {1:.2f})\" fill=\"none\" stroke=\"{5}\" "
      "stroke-width=\"0.5\" stroke-dasharray=\"2 1.5\"/>\n",
      at.x(), at.y(), 1e3 * place.tolerance->along, 1e3 * place.tolerance->around,
      degrees(std::atan2(-along.y(), along.x())), colour);
}

std::string distances(const placement::RankedPlace& place, const pattern::Panel& panel,
                      const io::PanelOnSheet& sheet) {
  std::string out;
  for (const pipeline::EdgeDistance& distance : pipeline::edge_distances(panel, place.at)) {
    out += path("distance", polyline({place.at, distance.foot}, sheet),
                "fill=\"none\" stroke=\"black\" stroke-width=\"0.25\"");
    const Vec2 foot = sheet.at(distance.foot), centre = sheet.at(place.at);
    Vec2 along = foot - centre;
    if (along.norm() < 1e-6) continue;  // the centre lies on the edge
    if (along.x() < 0) along = -along;  // words are read from left to right
    const Vec2 middle = centre + 0.6 * (foot - centre);
    const double turn = degrees(std::atan2(along.y(), along.x()));
    out += fmt::format("    <g transform=\"rotate({:.2f} {:.2f} {:.2f})\">\n", turn, middle.x(),
                       middle.y());
    out += rimmed_text(
        middle - Vec2(0, 1), 4,
        fmt::format("{:.0f} mm to {}", 1e3 * distance.length, panel.edges[distance.edge].name),
        "middle");
    out += "    </g>\n";
  }
  return out;
}

}  // namespace

std::string forbidden_marks(const pattern::Panel& panel, const std::set<int>& sewn,
                            const placement::SearchConstraints& constraints,
                            const io::PanelOnSheet& sheet) {
  const std::string clip = "clip-" + io::svg_escaped(panel.name);
  std::string out = fmt::format(
      "    <clipPath id=\"{}\"><path d=\"{} Z\"/></clipPath>\n    <g class=\"forbidden\" "
      "clip-path=\"url(#{})\" opacity=\"0.18\">\n",
      clip, polyline(pattern::outline_polygon(panel), sheet), clip);
  for (int e = 0; e < static_cast<int>(panel.edges.size()); ++e) {
    const double clearance =
        sewn.count(e) ? constraints.seam_clearance : constraints.edge_clearance;
    if (clearance <= 0) continue;
    out += path(
        "border", polyline(pattern::edge_points(panel, e, kEdgePieces), sheet),
        fmt::format("fill=\"none\" stroke=\"#c00000\" stroke-width=\"{:.2f}\"", 2e3 * clearance));
  }
  for (const placement::KeepOutZone& zone : constraints.keep_out.zones) {
    if (zone.panel != panel.name) continue;
    if (zone.shape == placement::KeepOutZone::Shape::disc) {
      const Vec2 at = sheet.at(zone.centre);
      out += fmt::format(
          "    <circle class=\"zone\" cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{:.2f}\" "
          "fill=\"#c00000\"/>\n",
          at.x(), at.y(), 1e3 * zone.radius);
    } else {
      const Vec2 at = sheet.at({zone.lower.x(), zone.upper.y()});
      const Vec2 size = 1e3 * (zone.upper - zone.lower);
      out += fmt::format(
          "    <rect class=\"zone\" x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" "
          "fill=\"#c00000\"/>\n",
          at.x(), at.y(), size.x(), size.y());
    }
  }
  return out + "    </g>\n";
}

std::string sensor_marks(const placement::RankedPlace& place, const pattern::Panel& panel,
                         const io::PanelOnSheet& sheet, bool passes) {
  const char* colour = passes ? kPass : kShort;
  const Vec2 at = sheet.at(place.at);
  std::string out = ellipse(place, sheet, colour) + outline(place, sheet, colour);
  if (place.shape.kind != Kind::girth) out += axis(place, sheet, colour);
  out += path("centre",
              fmt::format("M {} L {} M {} L {}", point(at - Vec2(2, 0)), point(at + Vec2(2, 0)),
                          point(at - Vec2(0, 2)), point(at + Vec2(0, 2))),
              "fill=\"none\" stroke=\"black\" stroke-width=\"0.3\"");
  return out + distances(place, panel, sheet);
}

std::string line_marks(const placement::RankedPlace& place, const std::string& panel,
                       const io::PanelOnSheet& sheet) {
  std::string out;
  for (const auto& [name, at] : place.line) {
    if (name != panel) continue;
    const Vec2 p = sheet.at(at);
    out += fmt::format(
        "    <circle class=\"line\" cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"1\" fill=\"{}\"/>\n", p.x(),
        p.y(), kPass);
  }
  return out;
}

std::string failing_mark(const placement::RankedPlace& place, const std::string& name,
                         const io::PanelOnSheet& sheet) {
  const Vec2 at = sheet.at(place.at);
  return path("failing",
              fmt::format("M {} L {} M {} L {}", point(at + Vec2(-2, -2)), point(at + Vec2(2, 2)),
                          point(at + Vec2(-2, 2)), point(at + Vec2(2, -2))),
              "fill=\"none\" stroke=\"#808080\" stroke-width=\"0.5\"") +
         rimmed_text(at + Vec2(4, 1.5), 4, name, "start", "#606060");
}

std::vector<Vec2> marked_points(const placement::RankedPlace& place, const pattern::Panel& panel,
                                const io::PanelOnSheet& sheet) {
  constexpr int kPieces = 40;
  std::vector<Vec2> points;
  const Vec2 centre = sheet.at(place.at);
  const auto line_to = [&](const Vec2& to) {
    for (int i = 0; i <= kPieces; ++i)
      points.push_back(centre + static_cast<double>(i) / kPieces * (to - centre));
  };
  for (const pipeline::EdgeDistance& d : pipeline::edge_distances(panel, place.at))
    line_to(sheet.at(d.foot));
  const Vec2 along = 1e-3 * (reach(place.shape) + kArrow) * placement::axis_in_pattern(place.angle);
  line_to(sheet.at(place.at + along));
  line_to(sheet.at(place.at - along));
  const double radius =
      place.shape.kind == Kind::line ? 2 : 1e3 * placement::outer_radius(place.shape);
  for (int i = 0; i < kPieces; ++i) {
    const double turn = 2 * kPi * i / kPieces;
    points.push_back(centre + radius * Vec2(std::cos(turn), std::sin(turn)));
  }
  return points;
}

std::string rimmed_text(const Vec2& at, double size, const std::string& words, const char* anchor,
                        const char* colour) {
  return fmt::format(
      "    <text x=\"{:.2f}\" y=\"{:.2f}\" font-size=\"{:g}\" text-anchor=\"{}\" fill=\"{}\" "
      "stroke=\"white\" stroke-width=\"1.2\" stroke-linejoin=\"round\" "
      "paint-order=\"stroke\">{}</text>\n",
      at.x(), at.y(), size, anchor, colour, io::svg_escaped(words));
}

}  // namespace loosefit::report

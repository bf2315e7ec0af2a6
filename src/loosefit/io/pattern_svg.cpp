#include "loosefit/io/pattern_svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "loosefit/base/text.h"
#include "loosefit/io/text_file.h"
#include "loosefit/pattern/hole.h"
#include "loosefit/pattern/outline.h"
#include "loosefit/pattern/pattern_check.h"

namespace loosefit::io {
namespace {

constexpr double kMm = 1000;          // per metre
constexpr double kGap = 30;           // between pieces [mm]
constexpr double kHead = 60;          // above the pieces: title [mm]
constexpr double kSheetWidth = 1400;  // a new row begins beyond [mm]
constexpr double kSquare = 100;       // control square [mm]
constexpr double kLine = 9;           // between lines of text [mm]
constexpr double kFaint = 0.35;       // opacity of names under marks

/// A piece and its place on the sheet.
struct Piece : PanelOnSheet {
  const pattern::Panel* panel = nullptr;
  std::vector<Vec2> outline;

  Vec2 on_sheet(const Vec2& p) const { return at(p); }
  Vec2 size() const { return (high - low) * kMm; }
};

/// Rows filled from left to right in panel order. Returns the extent of the sheet [mm].
Vec2 lay_out(std::vector<Piece>& pieces) {
  double widest = kSheetWidth;
  for (const Piece& piece : pieces) widest = std::max(widest, piece.size().x() + 2 * kGap);
  Vec2 at(kGap, kHead + kGap), extent(0, 0);
  double row = 0;
  for (Piece& piece : pieces) {
    if (at.x() > kGap && at.x() + piece.size().x() + kGap > widest) {
      at = Vec2(kGap, at.y() + row + kGap);
      row = 0;
    }
    piece.corner = at;
    row = std::max(row, piece.size().y());
    at.x() += piece.size().x() + kGap;
    extent = extent.cwiseMax(Vec2(at.x(), at.y() + row + kGap));
  }
  return extent;
}

std::string point(const Vec2& p) { return fmt::format("{:.3f} {:.3f}", p.x(), p.y()); }

std::string path_data(const Piece& piece) {
  const pattern::Panel& panel = *piece.panel;
  std::string d = "M " + point(piece.on_sheet(panel.vertices[panel.edges[0].start]));
  for (const pattern::PanelEdge& edge : panel.edges)
    for (std::size_t c = 0; c < edge.curves.size(); ++c) {
      const pattern::EdgeCurve& curve = edge.curves[c];
      const Vec2 to =
          piece.on_sheet(c < edge.knots.size() ? edge.knots[c] : panel.vertices[edge.end]);
      switch (curve.kind) {
        case pattern::EdgeCurve::Kind::line:
          d += " L " + point(to);
          break;
        case pattern::EdgeCurve::Kind::quadratic:
          d += " Q " + point(piece.on_sheet(curve.control[0])) + " " + point(to);
          break;
        case pattern::EdgeCurve::Kind::cubic:
          d += " C " + point(piece.on_sheet(curve.control[0])) + " " +
               point(piece.on_sheet(curve.control[1])) + " " + point(to);
          break;
        case pattern::EdgeCurve::Kind::circle:  // y turns over, and with it the sense of rotation
          d += fmt::format(" A {0:.3f} {0:.3f} 0 {1} {2} {3}", curve.radius * kMm,
                           curve.large_arc ? 1 : 0, curve.sweep ? 0 : 1, point(to));
          break;
      }
    }
  return d + " Z";
}

/// Holes as lines of their own, so that they keep their names.
std::string hole_lines(const Piece& piece) {
  std::string out;
  for (const pattern::PanelHole& hole : piece.panel->holes) {
    std::string d = "M";
    for (const Vec2& p : hole.points) d += " " + point(piece.on_sheet(p));
    out += fmt::format(
        "    <path class=\"hole\" "
        "xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" inkscape:label=\"{}\" "
        "d=\"{} Z\" fill=\"white\" stroke=\"black\" stroke-width=\"0.7\"/>\n",
        svg_escaped(hole.name), d);
  }
  return out;
}

std::string text(const Vec2& at, double size, const std::string& words, double angle_deg = 0) {
  const std::string turn =
      angle_deg == 0 ? "" : fmt::format(" transform=\"rotate({:.2f} {})\"", angle_deg, point(at));
  return fmt::format(
      "    <text x=\"{:.3f}\" y=\"{:.3f}\" font-size=\"{:g}\" text-anchor=\"middle\"{}>{}</text>\n",
      at.x(), at.y(), size, turn, svg_escaped(words));
}

/// Name and length of an edge, and how long its elastic is cut.
std::string edge_words(const pattern::PanelEdge& edge, double length) {
  std::string words = fmt::format("{}  {:.1f} mm", edge.name, length);
  if (edge.elastic) words += fmt::format("  elastic {:.1f} mm", edge.elastic->ratio * length);
  return words;
}

/// Name, length and seam number of an edge, inside the piece along the edge.
std::string edge_texts(const Piece& piece, int e, int seam) {
  const pattern::EdgePath path(*piece.panel, e);
  const Vec2 before = piece.on_sheet(path.at(.49)), after = piece.on_sheet(path.at(.51));
  const Vec2 along = (after - before).normalized();
  const Vec2 inwards(along.y(), -along.x());  // left of a counter-clockwise outline, y down
  const Vec2 middle = piece.on_sheet(path.at(.5));
  double angle = degrees(std::atan2(along.y(), along.x()));
  // Upside-down text is turned over; its baseline then lies on the other side of the letters.
  const bool over = std::abs(angle) > 90;
  if (over) angle += angle > 0 ? -180 : 180;
  std::string out;
  const double length = path.length() * kMm;
  if (length > 20) {
    const std::string words = edge_words(piece.panel->edges[e], length);
    const double size = std::min(5.0, 1.6 * length / static_cast<double>(words.size()));
    out += text(middle + (over ? 7.0 : 4.0) * inwards, size, words, angle);
  }
  if (seam > 0) {
    const Vec2 at = piece.on_sheet(path.at(.5)) + 15 * inwards;
    out += fmt::format(
        "    <circle cx=\"{:.3f}\" cy=\"{:.3f}\" r=\"4.5\" fill=\"white\" stroke=\"black\" "
        "stroke-width=\"0.3\"/>\n",
        at.x(), at.y());
    out += text(at + Vec2(0, 1.8), 5, std::to_string(seam));
  }
  return out;
}

/// A point well inside the piece, for its name: the best of a grid.
Vec2 inner_point(const Piece& piece) {
  Vec2 best = (piece.low + piece.high) / 2;
  double depth = -1;
  constexpr int kGrid = 24;
  for (int i = 1; i < kGrid; ++i)
    for (int j = 1; j < kGrid; ++j) {
      const Vec2 p =
          piece.low +
          (piece.high - piece.low).cwiseProduct(Vec2(double(i) / kGrid, double(j) / kGrid));
      if (!pattern::on_cloth(*piece.panel, piece.outline, p)) continue;
      double d = (pattern::closest_on_polygon(piece.outline, p) - p).norm();
      for (const pattern::PanelHole& hole : piece.panel->holes)
        d = std::min(d, (pattern::closest_on_polygon(hole.points, p) - p).norm());
      if (d > depth + 1e-9) depth = d, best = p;
    }
  return best;
}

std::string grain_arrow(const Vec2& at, double length) {
  const Vec2 top = at - Vec2(0, length / 2), bottom = at + Vec2(0, length / 2);
  return fmt::format(
      "    <path class=\"grain\" d=\"M {} L {} M {} L {} L {}\" fill=\"none\" stroke=\"black\" "
      "stroke-width=\"0.5\"/>\n",
      point(bottom), point(top), point(top + Vec2(-3, 7)), point(top), point(top + Vec2(3, 7)));
}

/// Rows of text from `at` downwards.
std::string text_lines(const Vec2& at, const std::vector<std::string>& lines) {
  std::string out;
  double y = at.y();
  for (const std::string& line : lines) {
    out += fmt::format("    <text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"6\">{}</text>\n", at.x(), y,
                       svg_escaped(line));
    y += kLine;
  }
  return out;
}

/// "1 side_L,  2 side_R, …" in rows that fit the width [mm].
std::vector<std::string> seam_lines(const pattern::Pattern& pattern, double width) {
  std::vector<std::string> lines;
  std::string line;
  for (std::size_t s = 0; s < pattern.stitches.size(); ++s) {
    line += fmt::format("{}{} {}", line.empty() ? "" : ",  ", s + 1, pattern.stitches[s].name);
    if (static_cast<double>(line.size()) * 3.2 > width) lines.push_back(std::move(line)), line = {};
  }
  if (!line.empty()) lines.push_back(line);
  return lines;
}

std::vector<Piece> pieces_of(const pattern::Pattern& pattern, const std::vector<int>& order) {
  std::vector<Piece> pieces;
  for (const int p : order) {
    Piece piece;
    piece.panel = &pattern.panels[p];
    piece.outline = pattern::outline_polygon(pattern.panels[p]);
    piece.low = piece.high = piece.outline[0];
    for (const Vec2& q : piece.outline) {
      piece.low = piece.low.cwiseMin(q);
      piece.high = piece.high.cwiseMax(q);
    }
    pieces.push_back(piece);
  }
  return pieces;
}

/// Outline, grain, name and size; edges with their seam numbers.
std::string drawn(const Piece& piece, const std::vector<int>& seams, double opacity) {
  std::string out = fmt::format(
      "    <path class=\"outline\" d=\"{}\" fill=\"#f4f4f0\" stroke=\"black\" "
      "stroke-width=\"0.7\"/>\n{}    <g opacity=\"{:g}\">\n",
      path_data(piece), hole_lines(piece), opacity);
  const Vec2 name_at = piece.on_sheet(inner_point(piece));
  const double name_size = std::clamp(piece.size().x() / 14, 4.0, 14.0);
  const double arrow = std::min(120.0, piece.size().y() / 4);
  out += grain_arrow(name_at + Vec2(0, arrow / 2 + 3 * name_size), arrow);
  out += text(name_at + Vec2(0, name_size), name_size, piece.panel->name);
  out += text(name_at + Vec2(0, 2.2 * name_size), name_size / 2,
              fmt::format("{:.0f} x {:.0f} mm", piece.size().x(), piece.size().y()));
  out += "    </g>\n";
  for (int e = 0; e < static_cast<int>(piece.panel->edges.size()); ++e)
    out += edge_texts(piece, e, seams[e]);
  return out;
}

/// `marks` null: the plain sheet.
std::string sheet_svg(const pattern::Pattern& pattern, const SheetMarks* marks) {
  pattern::check_pattern(pattern);
  // Number of the seam at every edge, 0 for free ones.
  std::vector<std::vector<int>> seam(pattern.panels.size());
  for (std::size_t p = 0; p < seam.size(); ++p) seam[p].assign(pattern.panels[p].edges.size(), 0);
  for (std::size_t s = 0; s < pattern.stitches.size(); ++s)
    for (const pattern::Stitch::Side& side :
         {pattern.stitches[s].first, pattern.stitches[s].second})
      seam[side.panel][side.edge] = static_cast<int>(s) + 1;
  // Pieces in panel order, laid out in rows.
  std::vector<int> order = pattern.panel_order;
  if (order.size() != pattern.panels.size()) {
    order.resize(pattern.panels.size());
    std::iota(order.begin(), order.end(), 0);
  }
  std::vector<Piece> pieces = pieces_of(pattern, order);
  Vec2 sheet = lay_out(pieces);
  // Below them the control square with the list of seams, or what the marks say, beside it.
  const Vec2 square(kGap, sheet.y());
  const std::vector<std::string> lines =
      marks ? marks->lines : seam_lines(pattern, sheet.x() - kSquare - 5 * kGap);
  sheet.x() = std::max(sheet.x(), kSquare + 2 * kGap);
  sheet.y() += std::max(kSquare, kLine * static_cast<double>(lines.size() + 1)) + kGap;
  std::size_t longest = 0;
  for (const std::string& line : lines) longest = std::max(longest, line.size());
  if (marks) sheet.x() = std::max(sheet.x(), kSquare + 3 * kGap + 3.2 * double(longest));

  // Head: title and scale.
  const std::string title = marks                  ? marks->title
                            : pattern.name.empty() ? std::string("pattern")
                                                   : pattern.name;
  const std::string words =
      marks
          ? marks->words
          : "scale 1:1, seen from the outside, no seam allowance; equal numbers are sewn together";
  std::string out = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.1f}mm\" height=\"{1:.1f}mm\" "
      "viewBox=\"0 0 {0:.1f} {1:.1f}\" font-family=\"sans-serif\">\n"
      "  <rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n"
      "  <g>\n    <text x=\"{2:g}\" y=\"35\" font-size=\"16\">{3}</text>\n"
      "    <text x=\"{2:g}\" y=\"52\" font-size=\"8\">{4}</text>\n  </g>\n",
      sheet.x(), sheet.y(), kGap, svg_escaped(title), svg_escaped(words));
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    out += fmt::format("  <g id=\"panel-{}\">\n", svg_escaped(pieces[i].panel->name));
    out += drawn(pieces[i], seam[order[i]], marks ? kFaint : 1);
    if (marks && marks->over_panel) out += marks->over_panel(order[i], pieces[i]);
    out += "  </g>\n";
  }
  out += fmt::format(
      "  <g id=\"control-square\">\n    <rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"100\" "
      "height=\"100\" fill=\"none\" stroke=\"black\" stroke-width=\"0.5\"/>\n",
      square.x(), square.y());
  out += text(square + Vec2(50, 53), 8, "100 x 100 mm");
  out += text_lines(square + Vec2(kSquare + kGap, 10), lines);
  return out + "  </g>\n</svg>\n";
}

}  // namespace

std::string pattern_svg(const pattern::Pattern& pattern) { return sheet_svg(pattern, nullptr); }

std::string pattern_svg(const pattern::Pattern& pattern, const SheetMarks& marks) {
  return sheet_svg(pattern, &marks);
}

std::string svg_escaped(const std::string& text) {
  std::string out;
  for (const char c : without_controls(text)) {
    if (c == '&')
      out += "&amp;";
    else if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else if (c == '"')
      out += "&quot;";
    else if (static_cast<unsigned char>(c) >= 0x20)
      out += c;
  }
  return out;
}

void write_pattern_svg(const std::filesystem::path& path, const pattern::Pattern& pattern) {
  write_text_file(path.string(), pattern_svg(pattern));
}

}  // namespace loosefit::io

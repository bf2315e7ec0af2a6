#include "loosefit/io/dxf/dxf_write.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "loosefit/base/control_characters.h"
#include "loosefit/base/error.h"
#include "loosefit/base/text.h"
#include "loosefit/io/text_file.h"
#include "loosefit/pattern/curve.h"
#include "loosefit/pattern/outline.h"
#include "loosefit/pattern/pattern_check.h"
#include "loosefit/pattern/piece_names.h"

namespace loosefit::io {
namespace {

constexpr double kMillimetre = 1000;  // per metre
constexpr double kChordError = 5e-6;  // [m]
constexpr double kBetween = 0.05;     // pieces side by side [m]
constexpr double kTextHeight = 5;     // [mm]
constexpr double kNotchDepth = 6;     // [mm]
constexpr int kMostChords = 1000;     // of a curve

/// Group codes and values on lines of their own.
class Writer {
 public:
  void group(int code, const std::string& value) {
    text_ += fmt::format("{:>3}\n{}\n", code, value);
  }
  void number(int code, double value) {
    group(code, fmt::format("{:.4f}", value == 0 ? 0.0 : value));
  }
  void entity(const char* kind, int layer) {
    group(0, kind);
    group(8, std::to_string(layer));
  }
  void at(const Vec2& p, int x_code = 10) {
    number(x_code, p.x());
    number(x_code + 10, p.y());
  }
  void polyline(int layer, const std::vector<Vec2>& points, bool closed) {
    entity("POLYLINE", layer);
    group(66, "1");
    at({0, 0});
    group(70, closed ? "1" : "0");
    for (const Vec2& p : points) {
      entity("VERTEX", layer);
      at(p);
    }
    entity("SEQEND", layer);
  }
  void line(int layer, const Vec2& a, const Vec2& b) {
    entity("LINE", layer);
    at(a);
    at(b, 11);
  }
  void text(int layer, const Vec2& p, const std::string& words) {
    entity("TEXT", layer);
    at(p);
    number(40, kTextHeight);
    group(1, without_controls(words));
  }
  std::string take() { return std::move(text_); }

 private:
  std::string text_;
};

std::string one_line(const std::string& words) {
  return replace_controls(words, [](const std::string&) { return std::string(" "); });
}

/// Points of an edge, both ends included.
std::vector<Vec2> chords(const pattern::Panel& panel, const pattern::PanelEdge& edge) {
  std::vector<Vec2> points{panel.vertices[edge.start]};
  for (std::size_t c = 0; c < edge.curves.size(); ++c) {
    const pattern::EdgeCurve& curve = edge.curves[c];
    const Vec2 a = points.back();
    const Vec2 b = c < edge.knots.size() ? edge.knots[c] : panel.vertices[edge.end];
    if (curve.kind != pattern::EdgeCurve::Kind::line) {
      // Chords of a curve of length L that turns as a circle does leave it by L²/(8 n²) times its
      // largest curvature; the turn of the tangents over pieces bounds that.
      int n = 8;
      const auto error = [&](int parts) {
        double worst = 0;
        for (int i = 0; i < parts; ++i) {
          const Vec2 p = pattern::curve_point(curve, a, b, double(i) / parts),
                     q = pattern::curve_point(curve, a, b, double(i + 1) / parts),
                     m = pattern::curve_point(curve, a, b, (i + 0.5) / parts);
          const Vec2 along = (q - p).normalized();
          const Vec2 off = m - p;
          worst = std::max(worst,
                           along.allFinite() ? (off - off.dot(along) * along).norm() : off.norm());
        }
        return worst;
      };
      while (n < kMostChords && error(n) > kChordError) n = n * 3 / 2;
      for (int i = 1; i < n; ++i)
        points.push_back(pattern::curve_point(curve, a, b, double(i) / n));
    }
    points.push_back(b);
  }
  return points;
}

struct Extent {
  Vec2 low = Vec2::Constant(1e9), high = Vec2::Constant(-1e9);
};

Extent extent_of(const std::vector<Vec2>& line) {
  Extent e;
  for (const Vec2& p : line) e.low = e.low.cwiseMin(p), e.high = e.high.cwiseMax(p);
  return e;
}

/// A name that blocks may have: letters, digits, "-" and "_", none twice.
std::string block_name(const std::string& name, std::vector<std::string>& taken) {
  std::string block;
  for (const char c : name.substr(0, 100))
    block += std::isalnum(static_cast<unsigned char>(c)) || c == '-' || c == '_' ? c : '_';
  if (block.empty()) block = "PIECE";
  std::string unique = block;
  for (int k = 2; std::find(taken.begin(), taken.end(), unique) != taken.end(); ++k)
    unique = fmt::format("{}_{}", block, k);
  taken.push_back(unique);
  return unique;
}

Vec2 middle_of(const std::vector<Vec2>& points) {
  Vec2 sum = Vec2::Zero();
  for (const Vec2& p : points) sum += p;
  return sum / static_cast<double>(points.size());
}

/// The longest part, within closed lines, of the vertical line through the middle of their extent.
std::pair<Vec2, Vec2> longest_upright(const std::vector<std::vector<Vec2>>& lines) {
  const Extent extent = extent_of(lines.front());
  const double x = 0.5 * (extent.low.x() + extent.high.x());
  std::vector<double> crossings;
  for (const std::vector<Vec2>& line : lines)
    for (std::size_t i = 0; i < line.size(); ++i) {
      const Vec2 &a = line[i], &b = line[(i + 1) % line.size()];
      if ((a.x() > x) == (b.x() > x)) continue;
      crossings.push_back(a.y() + (x - a.x()) / (b.x() - a.x()) * (b.y() - a.y()));
    }
  std::sort(crossings.begin(), crossings.end());
  double low = extent.low.y(), high = extent.high.y(), longest = 0;
  for (std::size_t i = 0; i + 1 < crossings.size(); i += 2)
    if (crossings[i + 1] - crossings[i] > longest) {
      longest = crossings[i + 1] - crossings[i];
      low = crossings[i], high = crossings[i + 1];
    }
  return {Vec2(x, low), Vec2(x, high)};
}

/// Where the grain line goes: there, a little shortened.
std::pair<Vec2, Vec2> grain_in(const pattern::Panel& panel) {
  std::vector<std::vector<Vec2>> lines{pattern::outline_polygon(panel)};
  for (const pattern::PanelHole& hole : panel.holes) lines.push_back(hole.points);
  const auto [low, high] = longest_upright(lines);
  const Vec2 margin = 0.2 * (high - low);
  return {low + margin, high - margin};
}

/// A place in a hole for its name: its middle, or beside it where a hole bends round that.
Vec2 place_in(const std::vector<Vec2>& hole) {
  const Vec2 middle = middle_of(hole);
  if (pattern::inside_polygon(hole, middle)) return middle;
  const auto [low, high] = longest_upright({hole});
  return 0.5 * (low + high);
}

}  // namespace

std::string dxf_text(const pattern::Pattern& pattern, const std::vector<pattern::Notch>& notches,
                     const std::vector<PatternMark>& marks) {
  pattern::check_pattern(pattern);
  for (const PatternMark& mark : marks)
    if (pattern.find_panel(mark.panel) < 0 || mark.line.empty())
      throw InvalidInput({{}, 0, "mark " + printable(mark.name)}, "panel " + printable(mark.panel),
                         "a panel of the pattern and a place");
  std::vector<int> order = pattern.panel_order;
  if (order.size() != pattern.panels.size()) {
    order.resize(pattern.panels.size());
    std::iota(order.begin(), order.end(), 0);
  }
  Writer out;
  out.group(999, "DXF-AAMA, ASTM D6673; millimetres; written by Loosefit");
  out.group(0, "SECTION");
  out.group(2, "HEADER");
  out.group(9, "$ACADVER");
  out.group(1, "AC1009");
  out.group(9, "$INSUNITS");
  out.group(70, "4");
  out.group(0, "ENDSEC");
  out.group(0, "SECTION");
  out.group(2, "BLOCKS");
  std::vector<std::string> blocks;
  double right = 0;
  for (const int p : order) {
    const pattern::Panel& panel = pattern.panels[p];
    const Extent extent = extent_of(pattern::outline_polygon(panel));
    const Vec2 shift(right - extent.low.x(), -extent.low.y());
    right += extent.high.x() - extent.low.x() + kBetween;
    const auto placed = [&](const Vec2& q) -> Vec2 { return kMillimetre * (q + shift); };
    const auto all_placed = [&](std::vector<Vec2> points) {
      for (Vec2& q : points) q = placed(q);
      return points;
    };
    out.group(0, "BLOCK");
    out.group(8, "1");
    out.group(2, block_name(panel.name, blocks));
    out.group(70, "0");
    out.at({0, 0});
    const Vec2 words = placed((extent.low + extent.high) / 2);
    int row = 0;
    const auto note = [&](const std::string& text) {
      out.text(1, words - Vec2(0, 1.6 * kTextHeight * row++), text);
    };
    note("Piece Name: " + one_line(panel.name));
    note("Size: ONE");
    note("Quantity: 1");
    for (const int layer : {1, 14})
      for (const pattern::PanelEdge& edge : panel.edges)
        out.polyline(layer, all_placed(chords(panel, edge)), false);
    // A text in a cutout names it.
    for (const pattern::PanelHole& hole : panel.holes) {
      out.polyline(11, all_placed(hole.points), true);
      const bool says_hole = pattern::words_of(hole.name).hole;
      out.text(11, placed(place_in(hole.points)), (says_hole ? "" : "hole ") + one_line(hole.name));
    }
    for (const pattern::PanelEdge& edge : panel.edges) {
      out.entity("POINT", 2);
      out.at(placed(panel.vertices[edge.start]));
    }
    for (const pattern::Notch& notch : notches) {
      if (notch.panel != p) continue;
      out.entity("POINT", 4);
      out.at(placed(pattern::EdgePath(panel, notch.edge).at(notch.along)));
      out.number(30, kNotchDepth);
    }
    const auto [from, to] = grain_in(panel);
    out.line(7, placed(from), placed(to));
    for (const PatternMark& mark : marks) {
      if (mark.panel != panel.name) continue;
      const std::vector<Vec2> line = all_placed(mark.line);
      if (line.size() == 1) {
        out.entity("POINT", kMarkLayer);
        out.at(line[0]);
      } else {
        out.polyline(kMarkLayer, line, mark.closed);
      }
      out.text(kMarkLayer, line[0], one_line(mark.name));
    }
    out.group(0, "ENDBLK");
    out.group(8, "1");
  }
  out.group(0, "ENDSEC");
  out.group(0, "SECTION");
  out.group(2, "ENTITIES");
  for (const std::string& block : blocks) {
    out.entity("INSERT", 1);
    out.group(2, block);
    out.at({0, 0});
  }
  int row = 0;
  for (const std::string& words :
       {"Style Name: " + one_line(pattern.name.empty() ? "pattern" : pattern.name),
        std::string("Sample Size: ONE"), std::string("Units: METRIC"),
        std::string("Author: Loosefit")})
    out.text(1, {0, -20 - 2 * kTextHeight * row++}, words);
  out.group(0, "ENDSEC");
  out.group(0, "EOF");
  return out.take();
}

void write_dxf(const std::filesystem::path& path, const pattern::Pattern& pattern,
               const std::vector<pattern::Notch>& notches, const std::vector<PatternMark>& marks) {
  write_text_file(path.string(), dxf_text(pattern, notches, marks));
}

}  // namespace loosefit::io

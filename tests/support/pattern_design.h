#pragma once
#include <fmt/format.h>

#include <cmath>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "loosefit/base/types.h"

/// A design of closed lines, fold marks, holes and counts, in millimetres with y up, and the same
/// design in every dialect of pattern files that can say it.
namespace loosefit::testing_support {

using Line = std::vector<Vec2>;

struct DesignPart {
  std::string name;
  std::vector<Line> outlines;  ///< the first is the largest
  std::vector<Line> holes;     ///< within or at the edge of the first outline
  std::vector<std::pair<Vec2, Vec2>> folds;
  std::string count;            ///< what a text in it says: "cut 2, mirrored"; may be empty
  std::vector<double> areas;    ///< of the pieces it becomes [mm²]
  std::vector<int> hole_count;  ///< per piece
};
using Design = std::vector<DesignPart>;

inline double polygon_area(const Line& line) {
  double twice = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const Vec2 &a = line[i], &b = line[(i + 1) % line.size()];
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return std::abs(twice) / 2;
}

/// Points of an arc about the origin, both ends included [degrees].
inline Line arc(double radius, double from, double to, int n = 30) {
  Line line;
  for (int i = 0; i <= n; ++i) {
    const double angle = radians(from + (to - from) * i / n);
    line.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return line;
}

inline Line moved(Line line, const Vec2& by) {
  for (Vec2& p : line) p += by;
  return line;
}

/// Six parts of one seed: a half piece with holes apart from the fold and at it, a quarter of a
/// ring, a piece with two holes, two outlines in one part, one that is cut twice, a plain one.
inline Design drawn_design(unsigned seed) {
  std::mt19937 random(seed);
  const auto between = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random()) / 4294967296.0;
  };
  Design design;
  {
    const double w = between(180, 300), h = between(600, 900), top = w * between(0.7, 0.95);
    const double r = between(40, 80), r2 = between(20, 35);
    DesignPart half{"panelA", {{{0, 0}, {w, 0}, {top, h}, {0, h}}}, {}, {}, "", {}, {}};
    half.folds = {{{0, 0.1 * h}, {0, 0.4 * h}}};
    half.holes = {moved(arc(r, -90, 90), {0, 0.7 * h}), moved(arc(r2, 0, 350, 35), {w / 2, h / 4})};
    half.areas = {2 * (polygon_area(half.outlines[0]) - polygon_area(half.holes[0]) -
                       polygon_area(half.holes[1]))};
    half.hole_count = {3};
    design.push_back(half);
  }
  {
    const double inner = between(90, 160), outer = between(400, 700);
    Line ring = arc(outer, 0, 90);
    for (const Vec2& p : arc(inner, 90, 0)) ring.push_back(p);
    DesignPart quarter{"ringB", {ring}, {}, {}, "", {}, {}};
    quarter.folds = {{{0, inner + 40}, {0, outer - 60}}, {{inner + 30, 0}, {outer - 50, 0}}};
    quarter.areas = {4 * polygon_area(ring)};
    quarter.hole_count = {1};
    design.push_back(quarter);
  }
  {
    const double w = between(400, 700), h = between(700, 1300);
    DesignPart two{"tunicC", {{{0, 0}, {w, 0}, {w, h}, {0, h}}}, {}, {}, "", {}, {}};
    two.holes = {moved(arc(between(60, 110), 0, 350, 35), {w / 2, h / 2}),
                 moved(arc(between(20, 50), 0, 350, 35), {w / 2, h / 5})};
    two.areas = {polygon_area(two.outlines[0]) - polygon_area(two.holes[0]) -
                 polygon_area(two.holes[1])};
    two.hole_count = {2};
    design.push_back(two);
  }
  {
    const double w = between(200, 300), h = between(400, 600);
    const Line large{{0, 0}, {w, 0}, {w, h}, {0, h}},
        small{{w + 20, 0}, {w + 150, 0}, {w + 150, h - 50}, {w + 20, h - 80}};
    design.push_back(
        {"pairD", {large, small}, {}, {}, "", {polygon_area(large), polygon_area(small)}, {0, 0}});
  }
  {
    const double length = between(500, 700);
    const Line gore{{0, 0}, {between(150, 200), 0}, {100, length}, {0, length}};
    const char* const says[] = {"gore, cut 2, mirrored", "Cut 2", "1 pair", "gore x2", "Qty: 2"};
    design.push_back({"goreE",
                      {gore},
                      {},
                      {},
                      says[seed % 5],
                      {polygon_area(gore), polygon_area(gore)},
                      {0, 0}});
  }
  const Line plain{{0, 0}, {between(150, 200), 0}, {between(90, 140), 300}, {0, 350}};
  design.push_back({"plainF", {plain}, {}, {}, "cut 1", {polygon_area(plain)}, {0}});
  return design;
}

inline std::string svg_data(const Line& line, bool closed = true) {
  std::string d;
  for (const Vec2& p : line)
    d += fmt::format("{} {:.6f},{:.6f} ", d.empty() ? "M" : "L", p.x(), -p.y());
  return d + (closed ? "z" : "");
}

inline std::string svg_page(const std::string& attributes, const std::string& body) {
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" "
         "xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" " +
         attributes + " width=\"5000mm\" height=\"3000mm\" viewBox=\"0 -2000 5000 3000\">\n" +
         body + "</svg>\n";
}

/// A bracket beside a fold, as FreeSewing draws one: from the fold into the piece and back.
inline Line bracket(const std::pair<Vec2, Vec2>& fold) {
  const Vec2 along = (fold.second - fold.first).normalized();
  Vec2 in(-along.y(), along.x());
  if (in.sum() < 0) in = -in;
  return {fold.first, fold.first + 15 * in, fold.second + 15 * in, fold.second};
}

inline std::string as_freesewing_svg(const Design& design) {
  std::string body;
  double x = 0;
  for (const DesignPart& part : design) {
    const std::string id = "d." + part.name;
    body += fmt::format(
        "<g id=\"fs-stack-{0}\" transform=\"translate({1},0)\"><g "
        "id=\"fs-stack-{0}-part-{0}\">\n",
        id, x);
    for (const auto* lines : {&part.outlines, &part.holes})
      for (const Line& line : *lines)
        body += "<path class=\"fabric\" d=\"" + svg_data(line) + "\"/>\n";
    for (const auto& fold : part.folds)
      body +=
          "<path class=\"note\" marker-start=\"url(#cutonfoldFrom)\" "
          "marker-end=\"url(#cutonfoldTo)\" d=\"" +
          svg_data(bracket(fold), false) + "\"/>\n";
    if (!part.count.empty())
      body += "<text><textPath><tspan>" + part.count + "</tspan></textPath></text>\n";
    body += "</g></g>\n";
    x += 900;
  }
  return svg_page("freesewing=\"4.0.0\"", body);
}

inline std::string json_ops(const Line& line, bool closed) {
  std::string ops;
  for (const Vec2& p : line)
    ops += fmt::format("{}{{\"type\":\"{}\",\"to\":{{\"x\":{:.6f},\"y\":{:.6f}}}}}",
                       ops.empty() ? "" : ",", ops.empty() ? "move" : "line", p.x(), -p.y());
  return "[" + ops + (closed ? ",{\"type\":\"close\"}]" : "]");
}

inline std::string as_freesewing_json(const Design& design) {
  std::string parts;
  for (const DesignPart& part : design) {
    std::string paths;
    int number = 0;
    const auto add = [&](const std::string& ops, const std::string& attributes) {
      paths += fmt::format("{}\"p{}\":{{\"ops\":{},\"attributes\":{{\"list\":{{{}}}}}}}",
                           paths.empty() ? "" : ",", ++number, ops, attributes);
    };
    for (const auto* lines : {&part.outlines, &part.holes})
      for (const Line& line : *lines) add(json_ops(line, true), "\"class\":[\"fabric\"]");
    for (const auto& fold : part.folds)
      add(json_ops(bracket(fold), false),
          "\"class\":[\"note\"],\"marker-start\":[\"url(#cutonfoldFrom)\"]");
    parts += fmt::format(
        "{}{{\"d.{}\":{{\"paths\":{{{}}},\"points\":{{\"t\":{{\"x\":1,\"y\":1,\"attributes\":{{"
        "\"list\":{{\"data-text\":[\"{}\"]}}}}}}}}}}}}",
        parts.empty() ? "" : ",\n", part.name, paths, part.count);
  }
  return "{\"parts\":[" + parts + "]}";
}

/// \param how 0: labels on lines, 1: holes in one path with the outline, counts as texts
inline std::string as_inkscape_svg(const Design& design, int how) {
  std::string body;
  double x = 0;
  for (const DesignPart& part : design) {
    body +=
        fmt::format("<g inkscape:label=\"{}\" transform=\"translate({},0)\">\n",
                    how == 0 && !part.count.empty() ? part.name + ", " + part.count : part.name, x);
    for (std::size_t k = 0; k < part.outlines.size(); ++k) {
      std::string d = svg_data(part.outlines[k]);
      if (how == 1 && k == 0)
        for (const Line& hole : part.holes) d += " " + svg_data(hole);
      body += fmt::format("<path inkscape:label=\"{}{}\" fill-rule=\"evenodd\" d=\"{}\"/>\n",
                          part.name, k == 0 ? "" : "_2", d);
    }
    for (std::size_t k = 0; how == 0 && k < part.holes.size(); ++k)
      body +=
          fmt::format("<path inkscape:label=\"hole {}\" d=\"{}\"/>\n", k, svg_data(part.holes[k]));
    for (const auto& fold : part.folds)
      body += "<path inkscape:label=\"fold\" d=\"" + svg_data({fold.first, fold.second}, false) +
              "\"/>\n";
    if (how == 1 && !part.count.empty())
      body += "<text x=\"50\" y=\"-100\"><tspan>" + part.count + "</tspan></text>\n";
    body += "</g>\n";
    x += 900;
  }
  return svg_page("", body);
}

/// \param how 0: cutouts on layer 11, counts as "Quantity"; 1: on layer 1, counts as plain texts
inline std::string as_dxf(const Design& design, int how) {
  std::string out = "0\nSECTION\n2\nBLOCKS\n";
  const auto polyline = [&](int layer, const Line& line) {
    out += fmt::format("0\nPOLYLINE\n8\n{}\n66\n1\n70\n1\n", layer);
    for (const Vec2& p : line)
      out += fmt::format("0\nVERTEX\n8\n{}\n10\n{:.6f}\n20\n{:.6f}\n", layer, p.x(), p.y());
    out += fmt::format("0\nSEQEND\n8\n{}\n", layer);
  };
  const auto text = [&](const std::string& words) {
    out += "0\nTEXT\n8\n1\n10\n50.0\n20\n100.0\n40\n5\n1\n" + words + "\n";
  };
  for (const DesignPart& part : design) {
    out += "0\nBLOCK\n8\n1\n2\n" + part.name + "\n70\n0\n10\n0\n20\n0\n";
    text("Piece Name: " + part.name);
    if (!part.count.empty()) text(how == 0 ? "Quantity: " + part.count : part.count);
    for (const Line& line : part.outlines) polyline(1, line);
    for (const Line& line : part.holes) polyline(how == 0 ? 11 : 1, line);
    for (const auto& [a, b] : part.folds)
      out += fmt::format("0\nLINE\n8\n6\n10\n{:.6f}\n20\n{:.6f}\n11\n{:.6f}\n21\n{:.6f}\n", a.x(),
                         a.y(), b.x(), b.y());
    out += "0\nENDBLK\n8\n1\n";
  }
  out += "0\nENDSEC\n0\nSECTION\n2\nENTITIES\n";
  text("Units: METRIC");
  return out + "0\nENDSEC\n0\nEOF\n";
}

}  // namespace loosefit::testing_support

#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <sstream>
#include <string>

#include "loosefit/pattern/pattern.h"

namespace loosefit {

/// What readers refuse beyond, of formats whose numbers are not all coordinates [m].
inline constexpr double kLargestPiece = 20;

/// All that a file says of its pieces and seams, to tell whether two files say the same.
inline std::string pieces_text(const pattern::Pattern& pattern) {
  std::ostringstream text;
  text.precision(17);
  for (const pattern::Panel& panel : pattern.panels) {
    text << panel.name << '\n' << panel.translation.transpose() << ' ' << panel.rotation << '\n';
    for (const Vec2& v : panel.vertices) text << v.transpose() << ' ';
    for (const pattern::PanelEdge& edge : panel.edges) {
      text << '\n' << edge.start << ' ' << edge.end << ' ' << edge.name << ' ' << edge.label;
      for (const Vec2& knot : edge.knots) text << ' ' << knot.transpose();
      for (const pattern::EdgeCurve& c : edge.curves) {
        text << ' ' << static_cast<int>(c.kind) << ' ' << c.radius << c.large_arc << c.sweep;
        for (const Vec2& p : c.control) text << ' ' << p.transpose();
      }
    }
  }
  for (const pattern::Stitch& s : pattern.stitches)
    text << '\n'
         << s.first.panel << ' ' << s.first.edge << ' ' << s.second.panel << ' ' << s.second.edge
         << ' ' << s.right_wrong;
  return text.str();
}

/// The largest number that stands in a text, whatever it means; what overflows counts as it is.
inline double largest_number(const std::string& text) {
  double largest = 0;
  const char* at = text.c_str();
  const char* const end = at + text.size();
  while (at < end) {
    if (*at < '0' || *at > '9') {
      ++at;
      continue;
    }
    char* after = nullptr;
    largest = std::max(largest, std::strtod(at, &after));
    at = after;
  }
  return largest;
}

/// What is wrong with pieces that a reader gave without an error, asked without the checks that the
/// reader itself uses; empty if nothing. `extent`: the largest coordinate that the file can mean
/// [m], whatever its pieces are.
inline std::string wrong_pieces(const pattern::Pattern& pattern, double extent) {
  const auto finite = [](const Vec2& p) { return std::isfinite(p.x()) && std::isfinite(p.y()); };
  for (const pattern::Panel& panel : pattern.panels) {
    const auto wrong = [&](const char* what) { return panel.name + ": " + what; };
    const int corners = static_cast<int>(panel.vertices.size());
    if (panel.edges.size() < 2) return wrong("no outline");
    if (!panel.translation.allFinite() || !panel.rotation.allFinite())
      return wrong("a place that is no number");
    Vec2 low(std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity());
    Vec2 high = -low;
    double area = 0;
    for (std::size_t e = 0; e < panel.edges.size(); ++e) {
      const pattern::PanelEdge& edge = panel.edges[e];
      if (edge.start < 0 || edge.start >= corners || edge.end < 0 || edge.end >= corners)
        return wrong("a corner that is not there");
      if (edge.end != panel.edges[(e + 1) % panel.edges.size()].start)
        return wrong("an outline that is not closed");
      std::vector<Vec2> points = {panel.vertices[edge.start]};
      for (std::size_t c = 0; c < edge.curves.size(); ++c) {
        points.insert(points.end(), edge.curves[c].control.begin(), edge.curves[c].control.end());
        points.push_back(c < edge.knots.size() ? edge.knots[c] : panel.vertices[edge.end]);
      }
      for (std::size_t i = 0; i < points.size(); ++i) {
        if (!finite(points[i])) return wrong("a point that is no number");
        low = low.cwiseMin(points[i]), high = high.cwiseMax(points[i]);
        if (i) area += points[i - 1].x() * points[i].y() - points[i].x() * points[i - 1].y();
      }
    }
    if (!((high - low).maxCoeff() > 0)) return wrong("no size");
    if (!std::isfinite(area)) return wrong("no area");
    // Coordinates of a file run from −extent to extent.
    if ((high - low).norm() > 2 * std::sqrt(2.0) * extent)
      return wrong("larger than anything in the file");
  }
  return {};
}

}  // namespace loosefit

#include "loosefit/pattern/pattern_check.h"

#include <fmt/format.h>

#include <cmath>
#include <set>

#include "loosefit/base/error.h"
#include "loosefit/pattern/hole.h"
#include "loosefit/pattern/outline.h"
#include "loosefit/pattern/self_crossing.h"

namespace loosefit::pattern {
namespace {

constexpr double kLargest = 20;     // extent of a piece [m]
constexpr double kShortest = 1e-6;  // edge [m]

bool sound(const Vec2& p) { return p.allFinite() && p.cwiseAbs().maxCoeff() < 1e6; }

std::string edge_at(const Panel& panel, int polygon_side, int per_curve) {
  int count = 0;
  for (const PanelEdge& edge : panel.edges)
    for (const EdgeCurve& curve : edge.curves) {
      count += curve.kind == EdgeCurve::Kind::line ? 1 : per_curve;
      if (polygon_side < count) return edge.name;
    }
  return "?";
}

void check_panel(const Panel& panel) {
  const std::string where = "panel " + panel.name;
  const auto fail = [&](const std::string& key, const std::string& found,
                        const std::string& expected, const std::string& hint = {}) {
    throw GeometryError(InputPlace{{}, 0, where + key}, found, expected, hint);
  };
  // Vertices and edges as such.
  const int corners = static_cast<int>(panel.vertices.size());
  const int n = static_cast<int>(panel.edges.size());
  if (n < 2) fail("", fmt::format("{} edges", n), "a closed loop of at least two edges");
  for (const Vec2& v : panel.vertices)
    if (!sound(v)) fail("", "a vertex that is not finite", "finite coordinates");
  for (int e = 0; e < n; ++e) {
    // Each edge: indices, one joint fewer than curves, and curves with finite numbers.
    const PanelEdge& edge = panel.edges[e];
    const std::string key = " edge " + edge.name;
    if (edge.start < 0 || edge.start >= corners || edge.end < 0 || edge.end >= corners)
      fail(key, fmt::format("end points {} and {}", edge.start, edge.end),
           fmt::format("vertex indices from 0 to {}", corners - 1));
    if (edge.curves.empty() || edge.knots.size() + 1 != edge.curves.size())
      fail(key, fmt::format("{} curves and {} joints", edge.curves.size(), edge.knots.size()),
           "one joint fewer than curves");
    for (const Vec2& k : edge.knots)
      if (!sound(k)) fail(key, "a joint that is not finite", "finite coordinates");
    for (const EdgeCurve& curve : edge.curves) {
      const std::size_t needed = curve.kind == EdgeCurve::Kind::quadratic ? 1
                                 : curve.kind == EdgeCurve::Kind::cubic   ? 2
                                                                          : 0;
      if (curve.control.size() != needed)
        fail(key, fmt::format("{} control points", curve.control.size()),
             fmt::format("{}", needed));
      for (const Vec2& c : curve.control)
        if (!sound(c)) fail(key, "a control point that is not finite", "finite coordinates");
      if (curve.kind == EdgeCurve::Kind::circle && !(curve.radius > 0 && curve.radius < 1e6))
        fail(key, fmt::format("radius {:.6g} m", curve.radius), "a positive radius");
    }
    // The edges follow each other and have a length.
    const PanelEdge& next = panel.edges[(e + 1) % n];
    if (edge.end != next.start)
      fail(key, fmt::format("end at vertex {}", edge.end),
           fmt::format("vertex {}, where edge {} starts", next.start, next.name),
           "the edges of a panel form one closed loop in list order");
    const double length = EdgePath(panel, e).length();
    if (!(length > kShortest))
      fail(key, fmt::format("length {:.3g} m", length), "a length above 1e-6 m");
  }
  // The outline as a whole: size, no crossing, counter-clockwise.
  constexpr int kPerCurve = 40;
  const std::vector<Vec2> outline = outline_polygon(panel, kPerCurve);
  Vec2 low = outline[0], high = outline[0];
  for (const Vec2& p : outline) low = low.cwiseMin(p), high = high.cwiseMax(p);
  if ((high - low).maxCoeff() > kLargest)
    fail("", fmt::format("a piece of {:.4g} m", (high - low).maxCoeff()),
         fmt::format("at most {:g} m", kLargest), "check the units of the pattern");
  const auto [i, j] = first_self_crossing(outline);
  if (i >= 0)
    fail("",
         fmt::format("an outline that crosses itself at edges {} and {}",
                     edge_at(panel, i, kPerCurve), edge_at(panel, j, kPerCurve)),
         "a simple outline");
  if (!(signed_area(outline) > 0)) fail("", "a clockwise outline", "a counter-clockwise outline");
  std::vector<PanelHole> cut;
  for (const PanelHole& hole : panel.holes) {
    const std::string key = " hole " + hole.name;
    for (const Vec2& p : hole.points)
      if (!sound(p)) fail(key, "a point that is not finite", "finite coordinates");
    if (const std::string fault = hole_fault(hole, outline, cut); !fault.empty())
      fail(key, fault, "a hole within the outline, apart from it and from other holes");
    if (!(signed_area(hole.points) > 0)) fail(key, "a clockwise rim", "a counter-clockwise rim");
    cut.push_back(hole);
  }
}

}  // namespace

void check_pattern(const Pattern& pattern) {
  if (pattern.panels.empty())
    throw GeometryError(InputPlace{{}, 0, "pattern"}, "no panels", "at least one panel");
  for (const Panel& panel : pattern.panels) check_panel(panel);
  std::set<std::pair<int, int>> sewn;
  for (std::size_t s = 0; s < pattern.stitches.size(); ++s) {
    const Stitch& stitch = pattern.stitches[s];
    const std::string key = "stitch " + (stitch.name.empty() ? std::to_string(s) : stitch.name);
    for (const Stitch::Side& side : {stitch.first, stitch.second}) {
      const int panels = static_cast<int>(pattern.panels.size());
      if (side.panel < 0 || side.panel >= panels)
        throw GeometryError(InputPlace{{}, 0, key}, fmt::format("panel {}", side.panel),
                            fmt::format("a panel index from 0 to {}", panels - 1));
      const Panel& panel = pattern.panels[side.panel];
      const int edges = static_cast<int>(panel.edges.size());
      if (side.edge < 0 || side.edge >= edges)
        throw GeometryError(
            InputPlace{{}, 0, key}, fmt::format("edge {}", side.edge),
            fmt::format("an edge index from 0 to {} of panel {}", edges - 1, panel.name));
      if (!sewn.insert({side.panel, side.edge}).second)
        throw GeometryError(InputPlace{{}, 0, key},
                            fmt::format("edge {} of panel {} a second time",
                                        panel.edges[side.edge].name, panel.name),
                            "each edge in at most one seam");
    }
  }
}

}  // namespace loosefit::pattern

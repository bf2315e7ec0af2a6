#include "loosefit/io/dxf/dxf_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "loosefit/base/error.h"
#include "loosefit/io/dxf/piece_outline.h"
#include "loosefit/pattern/curve.h"
#include "loosefit/pattern/outline.h"
#include "loosefit/pattern/pattern_check.h"

namespace loosefit::io {
namespace {

constexpr std::size_t kMostLines = 2000, kMostPoints = 5000;  // of one outline
constexpr double kNotchReach = 0.03;   // from a notch to the outline: a wide allowance [m]
constexpr double kSameCurve = 0.001;   // between two samplings of one curve [m]
constexpr double kShareOfPiece = 0.5;  // a sew line encloses at least so much of the piece
constexpr double kNarrowest = 0.002, kWidest = 0.06;  // seam allowance [m]
constexpr double kMm = 1000;

std::vector<Vec2> scaled(const DxfEntity& e, double metre) {
  std::vector<Vec2> points = e.points;
  for (Vec2& p : points) p *= metre;
  return points;
}

std::vector<DrawnLine> lines_on(const DxfBlock& block, int layer, double metre) {
  std::vector<DrawnLine> lines;
  for (const DxfEntity& e : block.entities)
    if (e.layer == layer && e.points.size() > 1)
      lines.push_back({scaled(e, metre), e.closed, e.kind == "POLYLINE" || e.kind == "LWPOLYLINE"});
  return lines;
}

std::vector<Vec2> points_on(const DxfBlock& block, int layer, double metre) {
  std::vector<Vec2> points;
  for (const DxfEntity& e : block.entities)
    if (e.layer == layer && e.kind == "POINT") points.push_back(metre * e.points[0]);
  return points;
}

std::vector<Vec2> polygon(const Outline& loop) {
  std::vector<Vec2> points;
  for (const OutlinePoint& p : loop) points.push_back(p.at);
  return points;
}

double perimeter(const Outline& loop) {
  double length = 0;
  for (std::size_t i = 0; i < loop.size(); ++i)
    length += (loop[(i + 1) % loop.size()].at - loop[i].at).norm();
  return length;
}

double distance_to(const std::vector<Vec2>& outline, const Vec2& p) {
  return (pattern::closest_on_polygon(outline, p) - p).norm();
}

bool lies_within(const Outline& inner, const Outline& outer) {
  const std::vector<Vec2> cut = polygon(outer);
  return std::all_of(inner.begin(), inner.end(), [&](const OutlinePoint& p) {
    return pattern::inside_polygon(cut, p.at) || distance_to(cut, p.at) < kChainGap;
  });
}

/// A closed line that follows the boundary at the distance of a seam allowance; at a fold it may
/// touch it.
bool follows_inside(const Outline& inner, const Outline& outer) {
  if (!lies_within(inner, outer)) return false;
  const std::vector<Vec2> cut = polygon(outer);
  std::size_t apart = 0;
  for (const OutlinePoint& p : inner) {
    const double d = distance_to(cut, p.at);
    if (d > kWidest) return false;
    apart += d > kNarrowest;
  }
  return 2 * apart > inner.size();
}

/// The same curve with more points: Gerber writes one on layer 84. (CLO writes control polygons
/// there, which are coarser.)
bool finer_copy(const Outline& fine, const Outline& coarse) {
  if (fine.size() <= coarse.size()) return false;
  const std::vector<Vec2> curve = polygon(fine);
  return std::abs(perimeter(fine) / perimeter(coarse) - 1) < 0.01 &&
         std::all_of(coarse.begin(), coarse.end(),
                     [&](const OutlinePoint& p) { return distance_to(curve, p.at) < kSameCurve; });
}

struct Layered {
  Outline outline;
  std::string fault;
};

Layered outline_on(const DxfBlock& block, int layer, double metre) {
  const std::vector<DrawnLine> lines = lines_on(block, layer, metre);
  if (lines.empty()) return {{}, fmt::format("nothing is drawn on layer {}", layer)};
  std::size_t points = 0;
  for (const DrawnLine& line : lines) points += line.points.size();
  if (lines.size() > kMostLines || points > kMostPoints)
    return {{},
            fmt::format("layer {} has {} lines with {} points, at most {} and {} are read", layer,
                        lines.size(), points, kMostLines, kMostPoints)};
  Chained chained = chain_lines(lines, points_on(block, 2, metre));
  for (Outline& loop : chained.loops)
    if (Outline clean = cleaned(std::move(loop)); !clean.empty()) return {std::move(clean), {}};
  return {
      {},
      fmt::format("its outline on layer {} is open by {:.2f} mm at ({:.6g}, {:.6g}), lines that "
                  "close within {:g} mm are expected",
                  layer, kMm * chained.widest_gap, chained.gap_at.x() / metre,
                  chained.gap_at.y() / metre, kMm * kChainGap)};
}

Layered best_outline(const DxfBlock& block, double metre, DxfPanel& result) {
  Layered cut = outline_on(block, 1, metre);
  Layered fine = outline_on(block, 84, metre);
  if (!fine.outline.empty() && (cut.outline.empty() || finer_copy(fine.outline, cut.outline)))
    cut = std::move(fine);
  if (cut.outline.empty()) return cut;
  const double enough = kShareOfPiece * outline_area(cut.outline);
  Layered sewn = outline_on(block, 14, metre);
  if (!lines_on(block, 14, metre).empty()) {
    if (!sewn.outline.empty() && outline_area(sewn.outline) >= enough &&
        lies_within(sewn.outline, cut.outline)) {
      result.on_sew_line = true;
      return sewn;
    }
    result.notes.push_back("its sew line (layer 14) is not taken, " +
                           (sewn.outline.empty() ? sewn.fault
                                                 : std::string("it does not lie within the "
                                                               "boundary")));
  }
  Layered inner = outline_on(block, 8, metre);
  if (!inner.outline.empty() && outline_area(inner.outline) >= enough &&
      follows_inside(inner.outline, cut.outline)) {
    result.on_sew_line = true;
    result.notes.push_back("the closed line on layer 8 along its boundary is taken as sew line");
    return inner;
  }
  return cut;
}

/// Notches of the file, and their mirror images in an unfolded piece.
std::vector<Vec2> notch_points(const DxfBlock& block, double metre) {
  std::vector<Vec2> points;
  for (const DxfEntity& e : block.entities)
    if ((e.layer == 4 || (e.layer >= 80 && e.layer <= 83)) && !e.points.empty() &&
        (e.kind == "POINT" || e.kind == "LINE"))
      points.push_back(metre * e.points[0]);
  return points;
}

/// First line on a layer that has two ends apart; false without one.
bool first_axis(const DxfBlock& block, int layer, double metre, Vec2& a, Vec2& b) {
  for (const DxfEntity& e : block.entities)
    if (e.layer == layer && e.points.size() > 1) {
      a = metre * e.points.front();
      b = metre * e.points.back();
      if ((b - a).norm() > kSamePoint) return true;
    }
  return false;
}

pattern::Panel panel_of(const Outline& loop) {
  pattern::Panel panel;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    if (loop[i].corner) {
      pattern::PanelEdge edge;
      edge.start = static_cast<int>(panel.vertices.size());
      edge.end = edge.start + 1;
      edge.name = fmt::format("e{}", panel.edges.size() + 1);
      panel.vertices.push_back(loop[i].at);
      panel.edges.push_back(edge);
    } else {
      panel.edges.back().knots.push_back(loop[i].at);
      panel.edges.back().curves.push_back({});
    }
  }
  panel.edges.back().end = 0;
  return panel;
}

/// Where on the outline a notch belongs, if it is near enough.
bool place_notch(const pattern::Panel& panel, const Vec2& p, pattern::Notch& notch) {
  double best = kNotchReach;
  bool found = false;
  for (std::size_t e = 0; e < panel.edges.size(); ++e) {
    const pattern::PanelEdge& edge = panel.edges[e];
    std::vector<Vec2> points{panel.vertices[edge.start]};
    points.insert(points.end(), edge.knots.begin(), edge.knots.end());
    points.push_back(panel.vertices[edge.end]);
    double length = 0, at = 0;
    bool here = false;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      const Vec2 side = points[i + 1] - points[i];
      const double t =
          std::clamp(side.dot(p - points[i]) / std::max(side.squaredNorm(), 1e-20), 0.0, 1.0);
      const double d = (points[i] + t * side - p).norm();
      if (d < best) best = d, here = true, at = length + t * side.norm();
      length += side.norm();
    }
    if (here) notch = {0, static_cast<int>(e), at / length}, found = true;
  }
  return found;
}

}  // namespace

DxfPanel make_panel(const DxfPiece& piece, double metre) {
  DxfPanel result;
  const DxfBlock& block = *piece.block;
  Layered best = best_outline(block, metre, result);
  if (best.outline.empty()) {
    result.fault = best.fault;
    return result;
  }
  Outline loop = std::move(best.outline);
  std::vector<Vec2> notches = notch_points(block, metre);
  Vec2 a, b;
  if (first_axis(block, 6, metre, a, b)) {
    switch (unfold(loop, a, b)) {
      case Fold::unfolded: {
        loop = cleaned(std::move(loop));
        result.unfolded = true;
        const Vec2 along = (b - a).normalized(), across(-along.y(), along.x());
        for (std::size_t i = 0, n = notches.size(); i < n; ++i)
          if (const double d = across.dot(notches[i] - a); std::abs(d) > kOnAxis)
            notches.push_back(notches[i] - 2 * d * across);
        break;
      }
      case Fold::whole:
        result.notes.push_back("its mirror line (layer 6) runs through it: taken as a whole piece");
        break;
      case Fold::beside:
        result.notes.push_back(
            "no part of its outline lies on its mirror line (layer 6): not unfolded");
        break;
    }
  }
  if (loop.empty()) {
    result.fault = "its outline encloses nothing";
    return result;
  }
  // Warp along y.
  double turn = 0;
  if (Vec2 from, to; first_axis(block, 7, metre, from, to))
    turn = kPi / 2 - std::atan2((to - from).y(), (to - from).x());
  else
    result.notes.push_back("it has no grain line (layer 7): the warp is taken along the file's y");
  const Eigen::Rotation2Dd rotation(turn);
  Vec2 low = Vec2::Constant(1e9), high = -low;
  for (OutlinePoint& p : loop) {
    p.at = rotation * p.at;
    low = low.cwiseMin(p.at);
    high = high.cwiseMax(p.at);
  }
  const Vec2 origin((low.x() + high.x()) / 2, low.y());
  for (OutlinePoint& p : loop) p.at -= origin;
  result.panel = panel_of(loop);
  result.panel.name = piece.name;
  for (const Vec2& p : notches)
    if (pattern::Notch notch; place_notch(result.panel, rotation * p - origin, notch))
      result.notches.push_back(notch);
  try {
    pattern::Pattern alone;
    alone.panels = {result.panel};
    pattern::check_pattern(alone);
  } catch (const GeometryError& error) {
    result.fault = error.what();
  }
  return result;
}

DxfPanel mirrored_piece(const DxfPanel& piece) {
  DxfPanel mirrored = piece;
  for (Vec2& v : mirrored.panel.vertices) v.x() = -v.x();
  std::vector<pattern::PanelEdge>& edges = mirrored.panel.edges;
  std::reverse(edges.begin(), edges.end());
  for (pattern::PanelEdge& edge : edges) {
    std::swap(edge.start, edge.end);
    std::reverse(edge.knots.begin(), edge.knots.end());
    for (Vec2& k : edge.knots) k.x() = -k.x();
    std::reverse(edge.curves.begin(), edge.curves.end());
    for (pattern::EdgeCurve& curve : edge.curves)
      curve = pattern::mirrored_curve(pattern::reversed_curve(curve));
  }
  const int last = static_cast<int>(edges.size()) - 1;
  for (pattern::Notch& notch : mirrored.notches) notch = {0, last - notch.edge, 1 - notch.along};
  return mirrored;
}

}  // namespace loosefit::io

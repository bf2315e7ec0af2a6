#include "loosefit/io/pieces/drawn_piece.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "loosefit/base/error.h"
#include "loosefit/pattern/curve.h"
#include "loosefit/pattern/pattern_check.h"

namespace loosefit::io {
namespace {

constexpr double kNotchReach = 0.03;  // from a notch to the outline: a wide allowance [m]
constexpr double kSideways = 22.5;    // of a grain, nearer to level than to the bias [degrees]

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

/// Unfolds the outline and mirrors the notches.
void unfold_piece(DrawnPiece& piece, PiecePanel& result) {
  const auto& [a, b] = *piece.fold;
  switch (unfold(piece.outline, a, b)) {
    case Fold::unfolded: {
      piece.outline = cleaned(std::move(piece.outline));
      result.unfolded = true;
      const Vec2 along = (b - a).normalized(), across(-along.y(), along.x());
      for (std::size_t i = 0, n = piece.notches.size(); i < n; ++i)
        if (const double d = across.dot(piece.notches[i] - a); std::abs(d) > kOnAxis)
          piece.notches.push_back(piece.notches[i] - 2 * d * across);
      break;
    }
    case Fold::whole:
      result.notes.push_back("its mirror line runs through it: taken as a whole piece");
      break;
    case Fold::beside:
      result.notes.push_back("no part of its outline lies on its mirror line: not unfolded");
      break;
  }
}

}  // namespace

void set_outline(DrawnPiece& piece, std::vector<Vec2> points, const std::vector<Vec2>& nodes) {
  if (points.size() < 3 || points.size() > kMostOutlinePoints) {
    piece.fault = fmt::format("its outline has {} points, 3 to {} are read", points.size(),
                              kMostOutlinePoints);
    return;
  }
  Chained chained = chain_lines({{std::move(points), true, false}}, nodes);
  if (!chained.loops.empty()) piece.outline = cleaned(std::move(chained.loops[0]));
}

void point_grains_up(const std::vector<DrawnPiece*>& pieces) {
  const auto along = [](const DrawnPiece& piece) -> Vec2 {
    return piece.grain->second - piece.grain->first;
  };
  const auto lies_sideways = [&](const DrawnPiece& piece) {
    const Vec2 grain = along(piece);
    return std::abs(grain.y()) < std::tan(radians(kSideways)) * std::abs(grain.x());
  };
  int to_the_right = 0;
  for (const DrawnPiece* piece : pieces)
    if (piece->grain && lies_sideways(*piece)) to_the_right += along(*piece).x() > 0 ? 1 : -1;
  for (DrawnPiece* piece : pieces) {
    if (!piece->grain) continue;
    const Vec2 grain = along(*piece);
    const bool down =
        lies_sideways(*piece) ? (grain.x() > 0) != (to_the_right >= 0) : grain.y() < 0;
    if (down) std::swap(piece->grain->first, piece->grain->second);
  }
}

PiecePanel panel_of_piece(DrawnPiece piece) {
  PiecePanel result;
  result.notes = std::move(piece.notes);
  result.on_sew_line = piece.on_sew_line;
  if (piece.outline.empty()) {
    result.fault = piece.fault.empty() ? "its outline encloses nothing" : piece.fault;
    return result;
  }
  if (piece.fold) unfold_piece(piece, result);
  Outline& loop = piece.outline;
  if (loop.empty()) {
    result.fault = "its outline encloses nothing";
    return result;
  }
  // Warp along y.
  double turn = 0;
  if (piece.grain) {
    const Vec2 along = piece.grain->second - piece.grain->first;
    turn = kPi / 2 - std::atan2(along.y(), along.x());
  }
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
  for (const Vec2& p : piece.notches)
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

PiecePanel mirrored_piece(const PiecePanel& piece) {
  PiecePanel mirrored = piece;
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

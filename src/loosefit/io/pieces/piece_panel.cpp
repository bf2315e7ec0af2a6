#include "loosefit/io/pieces/piece_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "loosefit/base/error.h"
#include "loosefit/base/text.h"
#include "loosefit/io/pieces/piece_folds.h"
#include "loosefit/pattern/curve.h"
#include "loosefit/pattern/hole.h"
#include "loosefit/pattern/outline.h"
#include "loosefit/pattern/pattern_check.h"

namespace loosefit::io {
namespace {

constexpr double kNotchReach = 0.03;  // from a notch to the outline: a wide allowance [m]

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

/// The holes in the frame of the panel; those that cannot be cut go to the notes.
void cut_holes(std::vector<pattern::PanelHole> holes, PiecePanel& result) {
  const std::vector<Vec2> outline = pattern::outline_polygon(result.panel);
  std::vector<pattern::PanelHole>& cut = result.panel.holes;
  for (pattern::PanelHole& hole : holes) {
    Outline loop;
    for (const Vec2& p : hole.points) loop.push_back({p});
    hole.points.clear();
    for (const OutlinePoint& p : cleaned(std::move(loop))) hole.points.push_back(p.at);
    std::string fault;
    if (hole.points.size() > kMostOutlinePoints)
      fault = fmt::format("its line has {} points, at most {} are read", hole.points.size(),
                          kMostOutlinePoints);
    else if (hole.points.size() < 3)
      fault = "its line encloses nothing";
    else
      fault = pattern::hole_fault(hole, outline, cut);
    if (!fault.empty()) {
      result.notes.push_back("its hole \"" + printable(hole.name) + "\" is not cut: " + fault);
      continue;
    }
    hole.name = pattern::free_hole_name(hole.name, cut);
    cut.push_back(std::move(hole));
  }
}

}  // namespace

PiecePanel panel_of_piece(DrawnPiece piece) {
  PiecePanel result;
  result.notes = std::move(piece.notes);
  result.on_sew_line = piece.on_sew_line;
  if (piece.outline.empty()) {
    result.fault = piece.fault.empty() ? "its outline encloses nothing" : piece.fault;
    return result;
  }
  Unfolded folds = unfold_piece(piece);
  result.unfolded = folds.times;
  result.half_without_fold = folds.times == 0 && (piece.half_without_fold || folds.beside);
  result.notes.insert(result.notes.end(), folds.notes.begin(), folds.notes.end());
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
  for (pattern::PanelHole& hole : piece.holes)
    for (Vec2& p : hole.points) p = rotation * p - origin;
  try {
    pattern::Pattern alone;
    alone.panels = {result.panel};
    pattern::check_pattern(alone);
  } catch (const GeometryError& error) {
    result.fault = error.what();
    return result;
  }
  cut_holes(std::move(piece.holes), result);
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
  mirrored.panel.holes = pattern::mirrored_holes(std::move(mirrored.panel.holes));
  for (pattern::Notch& notch : mirrored.notches) notch = {0, last - notch.edge, 1 - notch.along};
  return mirrored;
}

}  // namespace loosefit::io

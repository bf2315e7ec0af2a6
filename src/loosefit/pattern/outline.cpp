#include "loosefit/pattern/outline.h"

#include <algorithm>
#include <cmath>

#include "loosefit/geometry/flat_triangle.h"
#include "loosefit/pattern/curve.h"

namespace loosefit::pattern {

EdgePath::EdgePath(const Panel& panel, int edge) : curves_(panel.edges[edge].curves) {
  const PanelEdge& e = panel.edges[edge];
  knots_.push_back(panel.vertices[e.start]);
  knots_.insert(knots_.end(), e.knots.begin(), e.knots.end());
  knots_.push_back(panel.vertices[e.end]);
  cumulative_.push_back(0);
  for (std::size_t c = 0; c < curves_.size(); ++c)
    for (int i = 0; i < kPieces; ++i)
      cumulative_.push_back(cumulative_.back() + curve_length(curves_[c], knots_[c], knots_[c + 1],
                                                              double(i) / kPieces,
                                                              double(i + 1) / kPieces, 1));
}

std::pair<int, double> EdgePath::locate(double fraction) const {
  if (fraction <= 0) return {0, 0.0};
  if (fraction >= 1) return {static_cast<int>(curves_.size()) - 1, 1.0};
  const double arc = fraction * length();
  const auto above = std::upper_bound(cumulative_.begin() + 1, cumulative_.end() - 1, arc);
  const int piece = static_cast<int>(above - cumulative_.begin()) - 1;
  const int c = piece / kPieces;
  const double t0 = double(piece % kPieces) / kPieces, rest = arc - cumulative_[piece];
  double low = t0, high = t0 + 1.0 / kPieces;
  const double piece_length = cumulative_[piece + 1] - cumulative_[piece];
  double t = piece_length > 0 ? t0 + rest / piece_length / kPieces : t0;
  for (int iteration = 0; iteration < 60; ++iteration) {  // Newton, kept inside the bracket
    const double error = curve_length(curves_[c], knots_[c], knots_[c + 1], t0, t, 1) - rest;
    if (std::abs(error) <= 1e-15 * (1 + length())) break;
    (error > 0 ? high : low) = t;
    const double speed = curve_derivative(curves_[c], knots_[c], knots_[c + 1], t).norm();
    t = speed > 0 ? t - error / speed : low;
    if (!(t > low && t < high)) t = (low + high) / 2;
  }
  return {c, t};
}

Vec2 EdgePath::at(double fraction) const {
  if (fraction <= 0) return knots_.front();
  if (fraction >= 1) return knots_.back();
  const auto [c, t] = locate(fraction);
  return curve_point(curves_[c], knots_[c], knots_[c + 1], t);
}

std::vector<double> EdgePath::joint_fractions() const {
  std::vector<double> fractions;
  for (std::size_t c = 1; c < curves_.size(); ++c)
    fractions.push_back(length() > 0 ? cumulative_[c * kPieces] / length() : 0);
  return fractions;
}

std::vector<double> edge_lengths(const Panel& panel) {
  std::vector<double> lengths;
  for (std::size_t e = 0; e < panel.edges.size(); ++e)
    lengths.push_back(EdgePath(panel, static_cast<int>(e)).length());
  return lengths;
}

std::vector<Vec2> edge_points(const Panel& panel, int edge, int pieces) {
  const EdgePath path(panel, edge);
  std::vector<Vec2> points;
  for (int k = 0; k <= pieces; ++k) points.push_back(path.at(static_cast<double>(k) / pieces));
  return points;
}

std::vector<Vec2> outline_polygon(const Panel& panel, int per_curve) {
  std::vector<Vec2> polygon;
  for (const PanelEdge& edge : panel.edges)
    for (std::size_t c = 0; c < edge.curves.size(); ++c) {
      const Vec2& a = c == 0 ? panel.vertices[edge.start] : edge.knots[c - 1];
      const Vec2& b = c + 1 == edge.curves.size() ? panel.vertices[edge.end] : edge.knots[c];
      const int n = edge.curves[c].kind == EdgeCurve::Kind::line ? 1 : per_curve;
      for (int i = 0; i < n; ++i)
        polygon.push_back(curve_point(edge.curves[c], a, b, double(i) / n));
    }
  return polygon;
}

double signed_area(const std::vector<Vec2>& polygon) {
  double twice = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 p = polygon[i] - polygon[0], q = polygon[(i + 1) % polygon.size()] - polygon[0];
    twice += geometry::cross(p, q);
  }
  return twice / 2;
}

bool inside_polygon(const std::vector<Vec2>& polygon, const Vec2& p) {
  bool inside = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const Vec2 &a = polygon[i], &b = polygon[j];
    if ((a.y() > p.y()) != (b.y() > p.y()) &&
        p.x() < (b.x() - a.x()) * (p.y() - a.y()) / (b.y() - a.y()) + a.x())
      inside = !inside;
  }
  return inside;
}

Vec2 closest_on_polygon(const std::vector<Vec2>& polygon, const Vec2& p) {
  Vec2 best = polygon[0];
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 &a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    const double squared = (b - a).squaredNorm();
    const double t = squared > 0 ? std::clamp((p - a).dot(b - a) / squared, 0.0, 1.0) : 0;
    const Vec2 q = a + t * (b - a);
    if ((q - p).squaredNorm() < (best - p).squaredNorm()) best = q;
  }
  return best;
}

int find_edge(const Panel& panel, const std::string& name) {
  for (std::size_t e = 0; e < panel.edges.size(); ++e)
    if (panel.edges[e].name == name) return static_cast<int>(e);
  return -1;
}

int find_edge_part(const Panel& panel, const std::string& part) {
  for (std::size_t e = 0; e < panel.edges.size(); ++e)
    if (panel.edges[e].part == part) return static_cast<int>(e);
  return -1;
}

}  // namespace loosefit::pattern

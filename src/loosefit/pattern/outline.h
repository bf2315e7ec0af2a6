#pragma once
#include <string>
#include <vector>

#include "loosefit/pattern/pattern.h"

namespace loosefit::pattern {

/// One panel edge measured along its arc. Copies what it needs from the panel.
class EdgePath {
 public:
  EdgePath(const Panel& panel, int edge);
  double length() const { return cumulative_.back(); }  ///< [m]
  /// Point at a fraction of the arc length, 0 = start, 1 = end; both ends are hit exactly.
  Vec2 at(double fraction) const;
  /// Curve index and its parameter t at a fraction of the arc length.
  std::pair<int, double> locate(double fraction) const;
  const std::vector<EdgeCurve>& curves() const { return curves_; }
  const Vec2& knot(int i) const { return knots_[i]; }  ///< start, inner joints, end
  /// Fractions of the arc length at which one curve ends and the next begins.
  std::vector<double> joint_fractions() const;

 private:
  static constexpr int kPieces = 64;  // table intervals a curve
  std::vector<EdgeCurve> curves_;
  std::vector<Vec2> knots_;
  std::vector<double> cumulative_;  // arc length at every table point
};

/// Arc length of every edge [m].
std::vector<double> edge_lengths(const Panel& panel);
/// Points along an edge at even steps of its length, both ends included: one more than `pieces`.
std::vector<Vec2> edge_points(const Panel& panel, int edge, int pieces);
/// Dense closed polygon of the outline: `per_curve` points a curve (1 for lines), first point once.
std::vector<Vec2> outline_polygon(const Panel& panel, int per_curve = 40);
/// Signed area of a closed polygon [m²], positive counter-clockwise.
double signed_area(const std::vector<Vec2>& polygon);
/// Even-odd rule.
bool inside_polygon(const std::vector<Vec2>& polygon, const Vec2& p);
/// Nearest point on the polygon's sides.
Vec2 closest_on_polygon(const std::vector<Vec2>& polygon, const Vec2& p);
/// Index of an edge by name, -1 if there is none.
int find_edge(const Panel& panel, const std::string& name);
/// The same by PanelEdge::part.
int find_edge_part(const Panel& panel, const std::string& part);

}  // namespace loosefit::pattern

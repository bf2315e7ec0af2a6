#pragma once
#include <vector>

#include "loosefit/base/types.h"

namespace loosefit::io {

/// Points of an arc, both ends included, at least every 2 degrees (chord error 0.15 ‰ of the
/// radius). Angles in radians; runs from `from` over `sweep`, counter-clockwise when positive.
std::vector<Vec2> arc_points(const Vec2& centre, double radius, double from, double sweep);

/// Points behind `a` up to and including `b` of a polyline's segment with a bulge, the tangent of a
/// quarter of the arc's angle (Autodesk, DXF Reference, LWPOLYLINE, code 42); 0 is straight.
std::vector<Vec2> bulge_points(const Vec2& a, const Vec2& b, double bulge);

/// A rational B-spline: knots.size() = control.size() + degree + 1, not
/// decreasing; weights as many as control points or none.
struct DxfSpline {
  int degree = 3;
  std::vector<double> knots, weights;
  std::vector<Vec2> control;

  /// Why it cannot be evaluated; empty when it can.
  const char* fault() const;
};
/// 64 points a knot span, both ends included. The spline must have no fault.
std::vector<Vec2> spline_points(const DxfSpline& spline);

}  // namespace loosefit::io

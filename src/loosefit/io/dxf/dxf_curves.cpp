#include "loosefit/io/dxf/dxf_curves.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace loosefit::io {
namespace {

constexpr double kStep = 2 * std::numbers::pi / 180;  // [rad]
constexpr int kSpanPoints = 64;

/// De Boor's algorithm in homogeneous coordinates; u lies in the span [knots[k], knots[k + 1]].
Vec2 spline_point(const DxfSpline& spline, int k, double u) {
  std::vector<Vec3> d;
  for (int j = 0; j <= spline.degree; ++j) {
    const int i = j + k - spline.degree;
    const double w = spline.weights.empty() ? 1 : spline.weights[i];
    d.push_back({w * spline.control[i].x(), w * spline.control[i].y(), w});
  }
  for (int r = 1; r <= spline.degree; ++r)
    for (int j = spline.degree; j >= r; --j) {
      const int i = j + k - spline.degree;
      const double width = spline.knots[i + spline.degree + 1 - r] - spline.knots[i];
      const double t = width > 0 ? (u - spline.knots[i]) / width : 0;
      d[j] = (1 - t) * d[j - 1] + t * d[j];
    }
  return d[spline.degree].head<2>() / d[spline.degree].z();
}

}  // namespace

std::vector<Vec2> arc_points(const Vec2& centre, double radius, double from, double sweep) {
  const int count = std::max(1, static_cast<int>(std::ceil(std::abs(sweep) / kStep)));
  std::vector<Vec2> points;
  for (int i = 0; i <= count; ++i) {
    const double angle = from + sweep * i / count;
    points.push_back(centre + radius * Vec2(std::cos(angle), std::sin(angle)));
  }
  return points;
}

std::vector<Vec2> bulge_points(const Vec2& a, const Vec2& b, double bulge) {
  const Vec2 chord = b - a;
  if (std::abs(bulge) < 1e-9 || chord.norm() == 0) return {b};
  const double sweep = 4 * std::atan(bulge);
  // The centre lies left of the chord for a counter-clockwise arc below half a circle.
  const double apothem = (1 - bulge * bulge) / (4 * bulge);
  const Vec2 centre = (a + b) / 2 + apothem * Vec2(-chord.y(), chord.x());
  const Vec2 arm = a - centre;
  std::vector<Vec2> points = arc_points(centre, arm.norm(), std::atan2(arm.y(), arm.x()), sweep);
  points.erase(points.begin());
  points.back() = b;
  return points;
}

const char* DxfSpline::fault() const {
  if (degree < 1 || degree > 10) return "a degree beyond 1 to 10";
  if (control.size() < static_cast<std::size_t>(degree) + 1) return "too few control points";
  if (knots.size() != control.size() + degree + 1)
    return "knots that do not fit the control points";
  if (!std::is_sorted(knots.begin(), knots.end())) return "decreasing knots";
  if (!(knots[degree] < knots[control.size()])) return "knots that are all equal";
  if (!weights.empty() && weights.size() != control.size())
    return "weights that do not fit the control points";
  if (std::any_of(weights.begin(), weights.end(), [](double w) { return !(w > 1e-6); }))
    return "a weight that is not positive";
  return "";
}

std::vector<Vec2> spline_points(const DxfSpline& spline) {
  std::vector<Vec2> points;
  const int last = static_cast<int>(spline.control.size());
  for (int k = spline.degree; k < last; ++k) {
    const double a = spline.knots[k], b = spline.knots[k + 1];
    if (!(a < b)) continue;
    for (int i = points.empty() ? 0 : 1; i <= kSpanPoints; ++i)
      points.push_back(spline_point(spline, k, a + (b - a) * i / kSpanPoints));
  }
  return points;
}

}  // namespace loosefit::io

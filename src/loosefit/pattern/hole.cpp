#include "loosefit/pattern/hole.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "loosefit/geometry/flat_triangle.h"
#include "loosefit/pattern/outline.h"
#include "loosefit/pattern/self_crossing.h"

namespace loosefit::pattern {
namespace {

constexpr double kCorner = 40;      // a rim turns by more at a corner [degrees]
constexpr double kLeastRim = 1e-3;  // between a hole and what is next to it [m]
constexpr double kSmallest = 4e-4;  // the mesh of a garment has no room for less [m²]
constexpr int kLeastSegments = 8;
constexpr int kMostHalvings = 8;

double turn_deg(const Vec2& a, const Vec2& b, const Vec2& c) {
  const Vec2 u = b - a, v = c - b;
  return degrees(std::atan2(std::abs(geometry::cross(u, v)), u.dot(v)));
}

/// Places of the points along the rim, its length last.
std::vector<double> places(const PanelHole& hole) {
  std::vector<double> at{0};
  for (std::size_t i = 0; i < hole.points.size(); ++i)
    at.push_back(at.back() + (hole.points[(i + 1) % hole.points.size()] - hole.points[i]).norm());
  return at;
}

DividedHole divided_at(const PanelHole& hole, double edge_length) {
  const std::vector<double> at = places(hole);
  const std::size_t n = hole.points.size();
  std::vector<double> corners;
  for (std::size_t i = 0; i < n; ++i)
    if (turn_deg(hole.points[(i + n - 1) % n], hole.points[i], hole.points[(i + 1) % n]) > kCorner)
      corners.push_back(at[i]);
  if (corners.empty()) corners.push_back(0);
  const double length = at.back();
  const double step = std::min(edge_length, length / kLeastSegments);
  DividedHole divided;
  for (std::size_t c = 0; c < corners.size(); ++c) {
    const double from = corners[c];
    const double to = c + 1 < corners.size() ? corners[c + 1] : corners[0] + length;
    const int count = std::max(1, static_cast<int>(std::round((to - from) / step)));
    for (int i = 0; i < count; ++i) {
      divided.along.push_back(from + (to - from) * i / count);
      divided.points.push_back(point_on_rim(hole, divided.along.back()));
    }
  }
  return divided;
}

/// Least distance between two closed lines.
double gap_between(const std::vector<Vec2>& a, const std::vector<Vec2>& b) {
  if (polygons_meet(a, b)) return 0;
  double least = 1e9;
  for (const Vec2& p : a) least = std::min(least, (closest_on_polygon(b, p) - p).norm());
  for (const Vec2& p : b) least = std::min(least, (closest_on_polygon(a, p) - p).norm());
  return least;
}

}  // namespace

double rim_length(const PanelHole& hole) { return places(hole).back(); }

Vec2 point_on_rim(const PanelHole& hole, double along) {
  const std::vector<double> at = places(hole);
  along = std::fmod(along, at.back());
  const auto above = std::upper_bound(at.begin() + 1, at.end() - 1, along);
  const auto i = static_cast<std::size_t>(above - at.begin()) - 1;
  const Vec2 &a = hole.points[i], &b = hole.points[(i + 1) % hole.points.size()];
  const double side = at[i + 1] - at[i];
  return side > 0 ? Vec2(a + (along - at[i]) / side * (b - a)) : a;
}

DividedHole divided_hole(const PanelHole& hole, double edge_length) {
  DividedHole divided = divided_at(hole, edge_length);
  for (int k = 0; k < kMostHalvings &&
                  (divided.points.size() < 3 || first_self_crossing(divided.points).first >= 0);
       ++k)
    divided = divided_at(hole, edge_length /= 2);
  return divided;
}

std::string hole_fault(const PanelHole& hole, const std::vector<Vec2>& outline,
                       const std::vector<PanelHole>& others) {
  std::string fault = hole_place_fault(hole, outline, others);
  if (const double area = std::abs(signed_area(hole.points)); fault.empty() && area < kSmallest)
    fault = fmt::format("it has {:.2g} cm2, less than 4 cm2", 1e4 * area);
  return fault;
}

std::string hole_place_fault(const PanelHole& hole, const std::vector<Vec2>& outline,
                             const std::vector<PanelHole>& others) {
  if (hole.points.size() < 3 || first_self_crossing(hole.points).first >= 0)
    return "its line is not simple";
  const auto inside = std::count_if(hole.points.begin(), hole.points.end(),
                                    [&](const Vec2& p) { return inside_polygon(outline, p); });
  if (inside == 0) return "it does not lie in the piece";
  const double gap = gap_between(hole.points, outline);
  if (inside < static_cast<std::ptrdiff_t>(hole.points.size()) || gap < kLeastRim)
    return "it touches or crosses the outline of the piece";
  if (std::any_of(outline.begin(), outline.end(),
                  [&](const Vec2& p) { return inside_polygon(hole.points, p); }))
    return "it touches or crosses the outline of the piece";
  for (const PanelHole& other : others)
    if (inside_polygon(other.points, hole.points[0]) ||
        inside_polygon(hole.points, other.points[0]) ||
        gap_between(hole.points, other.points) < kLeastRim)
      return "it touches or crosses the hole \"" + other.name + '"';
  return {};
}

std::string free_hole_name(const std::string& wished, const std::vector<PanelHole>& others) {
  const std::string base = wished.empty() ? "hole" : wished;
  std::string name = base;
  const auto taken = [&](const PanelHole& other) { return other.name == name; };
  for (int k = 2; std::ranges::any_of(others, taken); ++k) name = fmt::format("{} {}", base, k);
  return name;
}

std::vector<PanelHole> mirrored_holes(std::vector<PanelHole> holes) {
  for (PanelHole& hole : holes) {
    for (Vec2& p : hole.points) p.x() = -p.x();
    std::reverse(hole.points.begin() + 1, hole.points.end());
  }
  return holes;
}

double cloth_area(const Panel& panel, int per_curve) {
  double area = signed_area(outline_polygon(panel, per_curve));
  for (const PanelHole& hole : panel.holes) area -= std::abs(signed_area(hole.points));
  return area;
}

bool on_cloth(const Panel& panel, const std::vector<Vec2>& outline, const Vec2& p) {
  return inside_polygon(outline, p) &&
         std::none_of(panel.holes.begin(), panel.holes.end(),
                      [&](const PanelHole& hole) { return inside_polygon(hole.points, p); });
}

}  // namespace loosefit::pattern

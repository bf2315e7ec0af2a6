#include "loosefit/pattern/sections.h"

#include <algorithm>
#include <cmath>

#include "loosefit/geometry/flat_triangle.h"
#include "loosefit/pattern/curve.h"
#include "loosefit/pattern/outline.h"

namespace loosefit::pattern {
namespace {

constexpr double kCorner = 30;      // [degrees]
constexpr double kTangent = 0.008;  // over which the direction at a corner is taken [m]

/// How far the outline turns to the left where the edge begins, −180 to 180 degrees.
double turn_before(const Panel& panel, int edge) {
  const int n = static_cast<int>(panel.edges.size());
  const EdgePath before(panel, (edge + n - 1) % n), after(panel, edge);
  const Vec2 at = after.at(0);
  const Vec2 in = at - before.at(std::max(0.0, 1 - kTangent / before.length()));
  const Vec2 out = after.at(std::min(1.0, kTangent / after.length())) - at;
  return degrees(std::atan2(geometry::cross(in, out), in.dot(out)));
}

}  // namespace

std::vector<Stitch::Side> Section::sides(const Panel& panel, int panel_index) const {
  std::vector<Stitch::Side> list;
  const int n = static_cast<int>(panel.edges.size());
  for (int k = 0; k < count; ++k) list.push_back({panel_index, (first + k) % n});
  return list;
}

std::vector<Vec2> section_points(const Panel& panel, const Section& section) {
  const int n = static_cast<int>(panel.edges.size());
  std::vector<Vec2> points;
  for (int k = 0; k < section.count; ++k) {
    const EdgePath path(panel, (section.first + k) % n);
    const int parts = std::clamp(static_cast<int>(path.length() / 0.004), 4, 200);
    for (int i = k == 0 ? 0 : 1; i <= parts; ++i) points.push_back(path.at(double(i) / parts));
  }
  return points;
}

std::vector<Section> outline_sections(const Panel& panel) {
  const int n = static_cast<int>(panel.edges.size());
  std::vector<int> begins;
  for (int e = 0; e < n; ++e)
    if (turn_before(panel, e) > kCorner) begins.push_back(e);
  if (begins.size() < 2) {
    begins.clear();
    for (int e = 0; e < n; ++e) begins.push_back(e);
  }
  std::vector<Section> sections;
  for (std::size_t i = 0; i < begins.size(); ++i) {
    Section s;
    s.first = begins[i];
    const int next = i + 1 < begins.size() ? begins[i + 1] : begins[0] + n;
    s.count = next - s.first;
    for (int k = 0; k < s.count; ++k) s.length += EdgePath(panel, (s.first + k) % n).length();
    const std::vector<Vec2> points = section_points(panel, s);
    s.from = points.front();
    s.to = points.back();
    s.bulge = signed_area(points) / std::max(1e-8, (s.to - s.from).squaredNorm());
    sections.push_back(s);
  }
  return sections;
}

double section_depth(const Panel& panel, const Section& section) {
  double deepest = 0;
  const Vec2 along = (section.to - section.from).normalized();
  for (const Vec2& q : section_points(panel, section))
    deepest = std::max(deepest, std::abs(geometry::cross(along, q - section.from)));
  return deepest;
}

}  // namespace loosefit::pattern

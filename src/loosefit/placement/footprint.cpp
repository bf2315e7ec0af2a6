#include "loosefit/placement/footprint.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "loosefit/base/error.h"
#include "loosefit/base/text.h"
#include "loosefit/maps/statistics.h"
#include "loosefit/placement/footprint_unfold.h"

namespace loosefit::placement {
namespace {

constexpr int kSplit = 6;            // a triangle is sampled at the centres of 36 equal parts,
constexpr double kFinest = 0.001;    // or of more until these are below this edge [m] …
constexpr int kSplitMost = 24;       // … or so many a side
constexpr double kLineStep = 0.001;  // [m]

Vec2 flat_point(const garment::Garment& garment, int triangle, const Vec3& b) {
  const auto& uv = garment.triangle_uv[triangle];
  return b[0] * uv[0] + b[1] * uv[1] + b[2] * uv[2];
}

double longest_edge(const std::array<Vec2, 3>& c) {
  return std::max({(c[1] - c[0]).norm(), (c[2] - c[1]).norm(), (c[0] - c[2]).norm()});
}

/// Disc or rectangle about the origin of the plane, axis along v.
struct Patch {
  const FootprintShape& shape;
  bool disc = shape.kind == FootprintShape::Kind::disc;
  bool covers(const Vec2& p) const {
    return disc ? p.norm() <= shape.radius
                : std::abs(p.x()) <= shape.size.x() / 2 && std::abs(p.y()) <= shape.size.y() / 2;
  }
  double reach() const { return disc ? shape.radius : shape.size.norm() / 2; }
  double least() const { return disc ? shape.radius : shape.size.minCoeff(); }
};

Footprint of_patch(const garment::Garment& garment, const std::vector<Vec3>& positions,
                   int triangle, const Vec2& centre, const Patch& patch, double angle,
                   const TriangleNeighbours* neighbours) {
  const Vec2 along = axis_in_pattern(angle), across(along.y(), -along.x());
  Footprint result;
  for (const FlatTriangle& flat : unfold(garment, triangle, centre, patch.reach(), neighbours)) {
    const Triangle& v = garment.triangles[flat.triangle];
    const double pieces = longest_edge(flat.corners) / std::max(kFinest, patch.least() / 6);
    const int split = std::clamp(static_cast<int>(std::ceil(pieces)), kSplit, kSplitMost);
    const double part = geometry::triangle_area(positions[v[0]], positions[v[1]], positions[v[2]]) /
                        (split * split);
    for (int i = 0; i < split; ++i)
      for (int j = 0; j < split - i; ++j)
        for (int down = 0; down < (i + j < split - 1 ? 2 : 1); ++down) {
          const double third = (1.0 + down) / 3;
          const Vec3 b((i + third) / split, (j + third) / split, 1 - (i + j + 2 * third) / split);
          Vec2 from_centre = -centre;
          for (int k = 0; k < 3; ++k) from_centre += b[k] * flat.corners[k];
          if (patch.covers({from_centre.dot(across), from_centre.dot(along)}))
            result.samples.push_back({flat.triangle, b, part});
        }
  }
  return result;
}

Footprint of_line(const garment::Garment& garment, int triangle, const Vec2& centre, double length,
                  double angle, const TriangleNeighbours* neighbours) {
  const Vec2 along = axis_in_pattern(angle);
  const std::vector<FlatTriangle> plane = unfold(garment, triangle, centre, length / 2, neighbours);
  const int parts = std::max(1, static_cast<int>(std::ceil(length / kLineStep - 1e-9)));
  Footprint result;
  for (int i = 0; i < parts; ++i) {
    const Vec2 p = centre + ((i + 0.5) / parts - 0.5) * length * along;
    for (const FlatTriangle& flat : plane) {
      const Vec3 b = weights_in(flat.corners, p);
      if (!(b.minCoeff() >= -1e-9)) continue;
      result.samples.push_back({flat.triangle, b, length / parts});
      break;
    }
  }
  return result;
}

}  // namespace

std::string in_words(const FootprintShape& footprint) {
  const auto millimetres = [](double metres) {
    return shortest(std::round(1e4 * metres) / 10 + 0.0);
  };
  switch (footprint.kind) {
    case FootprintShape::Kind::disc:
      return "disc of " + millimetres(2 * footprint.radius) + " mm";
    case FootprintShape::Kind::rectangle:
      return millimetres(footprint.size.x()) + " x " + millimetres(footprint.size.y()) + " mm";
    case FootprintShape::Kind::line:
      return "line of " + millimetres(footprint.length) + " mm";
    case FootprintShape::Kind::girth:
      break;
  }
  return "girth";
}

double area(const FootprintShape& footprint) {
  if (footprint.kind == FootprintShape::Kind::disc)
    return kPi * footprint.radius * footprint.radius;
  return footprint.kind == FootprintShape::Kind::rectangle ? footprint.size.prod() : 0;
}

double outer_radius(const FootprintShape& footprint) {
  switch (footprint.kind) {
    case FootprintShape::Kind::disc:
      return footprint.radius;
    case FootprintShape::Kind::rectangle:
      return 0.5 * footprint.size.norm();
    case FootprintShape::Kind::line:
      return 0.5 * footprint.length;
    case FootprintShape::Kind::girth:
      break;
  }
  return 0;
}

Vec2 axis_in_pattern(double angle) { return {-std::sin(angle), std::cos(angle)}; }

Footprint footprint(const garment::Garment& garment, const std::vector<Vec3>& positions,
                    int triangle, const Vec3& barycentric, const FootprintShape& shape,
                    double angle, const TriangleNeighbours* neighbours) {
  const Vec2 centre = flat_point(garment, triangle, barycentric);
  Footprint result;
  switch (shape.kind) {
    case FootprintShape::Kind::disc:
    case FootprintShape::Kind::rectangle:
      result = of_patch(garment, positions, triangle, centre, Patch{shape}, angle, neighbours);
      break;
    case FootprintShape::Kind::line:
      result = of_line(garment, triangle, centre, shape.length, angle, neighbours);
      break;
    case FootprintShape::Kind::girth:
      throw InvalidInput("a girth line is cut out of a drape, not out of the flat pattern");
  }
  if (result.samples.empty()) result.samples.push_back({triangle, barycentric, 1});
  return result;
}

Footprint footprint(const garment::Garment& garment, const std::vector<Vec3>& positions,
                    int triangle, const Vec3& barycentric, double radius) {
  FootprintShape disc;
  disc.radius = radius;
  return footprint(garment, positions, triangle, barycentric, disc, 0);
}

Footprint girth_footprint(const garment::Garment& garment, const std::vector<Vec3>& positions,
                          int triangle, const Vec3& barycentric, const Vec3& normal) {
  if (!(normal.norm() > 0))
    throw InvalidInput("a girth line needs the direction that it runs round");
  // Slightly inside its triangle, so that the plane cuts it even if the place is one of its
  // corners.
  const Vec3 inside = (1 - 1e-6) * barycentric + Vec3::Constant(1e-6 / 3);
  double level = 0;
  for (int k = 0; k < 3; ++k)
    level += inside[k] * normal.dot(positions[garment.triangles[triangle][k]]);
  // From triangle to triangle over the edges that the plane cuts.
  const auto beyond = triangle_neighbours(garment);
  std::vector<char> seen(garment.triangles.size(), 0);
  std::vector<int> open{triangle};
  seen[triangle] = 1;
  Footprint result;
  while (!open.empty()) {
    const int t = open.back();
    open.pop_back();
    Vec3 ends[2];
    int count = 0;
    for (int k = 0; k < 3; ++k) {
      const int next = (k + 1) % 3;
      // A corner exactly on the plane counts as above: a triangle is cut in two edges or none.
      const double a = normal.dot(positions[garment.triangles[t][k]]) - level,
                   b = normal.dot(positions[garment.triangles[t][next]]) - level;
      if ((a >= 0) == (b >= 0)) continue;
      ends[count].setZero();
      ends[count][next] = a / (a - b);
      ends[count++][k] = 1 - a / (a - b);
      const int other = beyond[t][k];
      if (other < 0 || seen[other]) continue;
      seen[other] = 1;
      open.push_back(other);
    }
    // Each cut triangle gives one sample, weighted by the flat length of the cut.
    if (count != 2) continue;
    const double length =
        (flat_point(garment, t, ends[1]) - flat_point(garment, t, ends[0])).norm();
    result.samples.push_back({t, (ends[0] + ends[1]) / 2, length});
  }
  // Ordered by triangle, so that the place where the search began makes no difference.
  std::sort(result.samples.begin(), result.samples.end(),
            [](const auto& a, const auto& b) { return a.triangle < b.triangle; });
  if (result.samples.empty()) result.samples.push_back({triangle, barycentric, 1});
  return result;
}

FootprintValue average(const Footprint& footprint, const garment::Garment& garment,
                       const std::vector<double>& vertex_values) {
  std::vector<double> values, weights;
  for (const Footprint::Sample& sample : footprint.samples) {
    double sum = 0, weight = 0;
    for (int k = 0; k < 3; ++k) {
      const double value = vertex_values[garment.triangles[sample.triangle][k]];
      if (std::isnan(value)) continue;
      sum += sample.barycentric[k] * value;
      weight += sample.barycentric[k];
    }
    values.push_back(weight > 0 ? sum / weight : std::numeric_limits<double>::quiet_NaN());
    weights.push_back(sample.area);
  }
  const maps::MapStatistics s = maps::statistics(values, weights);
  return {s.area_mean, s.p95};
}

}  // namespace loosefit::placement

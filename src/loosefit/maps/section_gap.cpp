#include "loosefit/maps/section_gap.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "loosefit/base/error.h"
#include "loosefit/body/section.h"

namespace loosefit::maps {
namespace {

using Polygon = std::vector<Vec2>;

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

double signed_area(const Polygon& p) {
  double sum = 0;
  for (std::size_t i = 0; i < p.size(); ++i) sum += 0.5 * cross(p[i], p[(i + 1) % p.size()]);
  return sum;
}

double girth(const Polygon& p) {
  double sum = 0;
  for (std::size_t i = 0; i < p.size(); ++i) sum += (p[(i + 1) % p.size()] - p[i]).norm();
  return sum;
}

double extent(const Polygon& p, int axis) {
  const auto [low, high] = std::minmax_element(
      p.begin(), p.end(), [axis](const Vec2& a, const Vec2& b) { return a[axis] < b[axis]; });
  return (*high)[axis] - (*low)[axis];
}

/// Left, back, right, front.
int quadrant_of(const Vec2& p) {
  if (std::abs(p.x()) >= std::abs(p.y())) return p.x() >= 0 ? 0 : 2;
  return p.y() >= 0 ? 1 : 3;
}

/// Area in each quadrant round the origin: the fan of a polygon, its edges cut at the diagonals.
std::array<double, 4> quadrant_areas(const Polygon& p) {
  std::array<double, 4> area = {};
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Vec2 &a = p[i], &b = p[(i + 1) % p.size()];
    std::vector<double> cuts = {0, 1};
    for (const Vec2& diagonal : {Vec2(1, 1), Vec2(1, -1)}) {
      const double u = cross(diagonal, a), v = cross(diagonal, b);
      if ((u < 0) != (v < 0)) cuts.push_back(u / (u - v));
    }
    std::sort(cuts.begin(), cuts.end());
    for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
      const Vec2 from = a + cuts[k] * (b - a), to = a + cuts[k + 1] * (b - a);
      area[quadrant_of(0.5 * (from + to))] += 0.5 * cross(from, to);
    }
  }
  return area;
}

/// Distance at which a ray from the origin leaves the polygon for the last time.
double farthest_along(const Polygon& p, const Vec2& direction) {
  double farthest = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Vec2 &a = p[i], &b = p[(i + 1) % p.size()];
    const double u = cross(direction, a), v = cross(direction, b);
    if ((u < 0) == (v < 0)) continue;
    farthest = std::max(farthest, direction.dot(a + u / (u - v) * (b - a)));
  }
  return farthest;
}

/// Counter-clockwise round the middle, which becomes the origin.
Polygon round_middle(Polygon p, const Vec2& middle, const char* what) {
  if (p.size() < 3) throw InvalidInput(std::string("section: the ") + what + " has no outline");
  if (signed_area(p) < 0) std::reverse(p.begin(), p.end());
  for (Vec2& q : p) q -= middle;
  double turned = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Vec2 &a = p[i], &b = p[(i + 1) % p.size()];
    turned += std::atan2(cross(a, b), a.dot(b));
  }
  if (std::abs(turned) < kPi)
    throw InvalidInput(std::string("section: the middle lies outside the ") + what);
  return p;
}

Polygon seen_from_above(const body::SectionLoop& loop) {
  Polygon p;
  for (const Vec3& q : loop.points) p.push_back(q.head<2>());
  return p;
}

}  // namespace

double SectionGap::filling() const {
  const double most = cloth_girth * cloth_girth / (4 * kPi) - body_area;
  return most > 0 ? gap_area() / most : std::numeric_limits<double>::quiet_NaN();
}

SectionGap section_gap(std::vector<Vec2> body, std::vector<Vec2> cloth, const Vec2& middle,
                       int rays) {
  const Polygon skin = round_middle(std::move(body), middle, "body");
  const Polygon outer = round_middle(std::move(cloth), middle, "cloth");
  SectionGap section;
  section.body_area = signed_area(skin), section.body_girth = girth(skin);
  section.cloth_area = signed_area(outer), section.cloth_girth = girth(outer);
  section.body_width = extent(skin, 0), section.body_depth = extent(skin, 1);
  section.cloth_width = extent(outer, 0), section.cloth_depth = extent(outer, 1);
  const auto inside = quadrant_areas(skin), all = quadrant_areas(outer);
  for (int k = 0; k < 4; ++k) section.quadrant[k] = all[k] - inside[k];
  for (int k = 0; k < rays; ++k) {
    const double angle = 2 * kPi * k / rays;
    const Vec2 direction(std::cos(angle), std::sin(angle));
    section.gap.push_back(farthest_along(outer, direction) - farthest_along(skin, direction));
  }
  return section;
}

std::optional<SectionGap> trunk_section(const garment::Garment& garment,
                                        const std::vector<Vec3>& positions, const WornGarment& worn,
                                        const body::Body& body, double level) {
  geometry::TriangleMesh cloth;
  cloth.vertices = positions;
  for (std::size_t t = 0; t < garment.triangles.size(); ++t)
    if (worn.panel_part[garment.triangle_panel[t]] == body::BodyPart::trunk)
      cloth.triangles.push_back(garment.triangles[t]);
  const Vec3 origin(0, 0, level), up = Vec3::UnitZ();
  const auto skins = body::plane_section(body.surface, origin, up);
  const body::SectionLoop* skin = body::trunk_loop(skins);
  if (!skin) return {};
  const Vec3 middle = body::centroid(*skin);
  const auto loops = body::plane_section(cloth, origin, up);
  const body::SectionLoop* round = nullptr;
  for (const body::SectionLoop& loop : loops)
    if (body::loop_contains(loop, up, middle) && (!round || loop.length > round->length))
      round = &loop;
  if (!round || !body::loop_contains(*skin, up, middle)) return {};
  SectionGap section =
      section_gap(seen_from_above(*skin), seen_from_above(*round), middle.head<2>());
  section.level = level;
  return section;
}

}  // namespace loosefit::maps

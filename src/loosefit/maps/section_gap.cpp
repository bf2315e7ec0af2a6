#include "loosefit/maps/section_gap.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "loosefit/base/error.h"
#include "loosefit/body/section.h"

namespace loosefit::maps {
namespace {

using Polygon = std::vector<Vec2>;

/// Shorter open pieces of cloth, tips of a wavy armhole, are none of a section [m].
constexpr double kLeastChain = 0.03;

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

/// Turn of a curve round the origin, counter-clockwise positive [rad].
double turn(const Polygon& p, bool closed) {
  double turned = 0;
  for (std::size_t i = 0; i + (closed ? 0 : 1) < p.size(); ++i) {
    const Vec2 &a = p[i], &b = p[(i + 1) % p.size()];
    turned += std::atan2(cross(a, b), a.dot(b));
  }
  return turned;
}

/// Counter-clockwise round the middle, which becomes the origin.
Polygon round_middle(Polygon p, const Vec2& middle, const char* what) {
  if (p.size() < 3) throw InvalidInput(std::string("section: the ") + what + " has no outline");
  if (signed_area(p) < 0) std::reverse(p.begin(), p.end());
  for (Vec2& q : p) q -= middle;
  if (std::abs(turn(p, true)) < kPi)
    throw InvalidInput(std::string("section: the middle lies outside the ") + what);
  return p;
}

/// Place on a closed polygon that is nearest to a point.
struct Place {
  std::size_t edge = 0;  ///< from this corner on
  double along = 0;      ///< length from the first corner [m]
  Vec2 point = Vec2::Zero();
};

Place nearest_place(const Polygon& p, const Vec2& to) {
  Place best;
  double nearest = std::numeric_limits<double>::infinity(), passed = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Vec2 edge = p[(i + 1) % p.size()] - p[i];
    const double length = edge.norm();
    const double share =
        length > 0 ? std::clamp((to - p[i]).dot(edge) / edge.squaredNorm(), 0.0, 1.0) : 0;
    const Vec2 point = p[i] + share * edge;
    if (const double distance = (to - point).norm(); distance < nearest)
      nearest = distance, best = {i, passed + share * length, point};
    passed += length;
  }
  return best;
}

/// Appends the shorter way along a closed polygon from one place to another; its length [m].
double append_way(const Polygon& p, const Place& from, const Place& to, Polygon& out) {
  const std::size_t n = p.size();
  const double whole = girth(p);
  const double ahead = std::fmod(to.along - from.along + whole, whole);
  out.push_back(from.point);
  if (ahead <= 0.5 * whole) {
    // Round the whole polygon never: the way is half of it at most.
    const bool same = from.edge == to.edge && to.along >= from.along;
    for (std::size_t i = from.edge; !same && i != to.edge; i = (i + 1) % n)
      out.push_back(p[(i + 1) % n]);
  } else {
    const bool same = from.edge == to.edge && to.along <= from.along;
    for (std::size_t i = from.edge; !same && i != to.edge; i = (i + n - 1) % n) out.push_back(p[i]);
  }
  out.push_back(to.point);
  return std::min(ahead, whole - ahead);
}

/// Cloth that armholes open, closed along the skin under them. Both round the origin, the skin
/// counter-clockwise. Nothing when a way along the skin is longer than `most_open`, or the whole
/// does not go round once.
std::optional<Polygon> close_along_skin(std::vector<Polygon> chains, const Polygon& skin,
                                        double most_open, double& opened) {
  std::erase_if(chains, [](const Polygon& c) {
    double length = 0;
    for (std::size_t i = 0; i + 1 < c.size(); ++i) length += (c[i + 1] - c[i]).norm();
    return length < kLeastChain;
  });
  if (chains.empty()) return {};
  for (Polygon& c : chains)
    if (turn(c, false) < 0) std::reverse(c.begin(), c.end());
  const auto middle = [](const Polygon& c) {
    const Vec2 m = c[c.size() / 2];
    return std::atan2(m.y(), m.x());
  };
  std::sort(chains.begin(), chains.end(),
            [&](const Polygon& a, const Polygon& b) { return middle(a) < middle(b); });
  Polygon all;
  opened = 0;
  for (std::size_t k = 0; k < chains.size(); ++k) {
    const Polygon& next = chains[(k + 1) % chains.size()];
    all.insert(all.end(), chains[k].begin(), chains[k].end());
    const double way = append_way(skin, nearest_place(skin, chains[k].back()),
                                  nearest_place(skin, next.front()), all);
    if (way > most_open) return {};
    opened += way;
  }
  if (std::abs(turn(all, true) - 2 * kPi) > 1e-6) return {};
  return all;
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
                                        const body::Body& body, double level, double most_open) {
  geometry::TriangleMesh cloth;
  cloth.vertices = positions;
  for (std::size_t t = 0; t < garment.triangles.size(); ++t)
    if (body::covers_trunk(worn.panel_part[garment.triangle_panel[t]]))
      cloth.triangles.push_back(garment.triangles[t]);
  const Vec3 origin(0, 0, level), up = Vec3::UnitZ();
  const auto skins = body::plane_section(body.surface, origin, up);
  const body::SectionLoop* skin = body::trunk_loop(skins);
  if (!skin) return {};
  const Vec3 middle = body::centroid(*skin);
  if (!body::loop_contains(*skin, up, middle)) return {};
  const auto loops = body::plane_section(cloth, origin, up);
  const body::SectionLoop* round = nullptr;
  for (const body::SectionLoop& loop : loops)
    if (body::loop_contains(loop, up, middle) && (!round || loop.length > round->length))
      round = &loop;
  std::optional<Polygon> outer;
  double opened = 0;
  if (round) {
    outer = seen_from_above(*round);
  } else if (most_open > 0) {
    const Polygon inner = round_middle(seen_from_above(*skin), middle.head<2>(), "body");
    std::vector<Polygon> chains;
    for (const body::SectionLoop& chain : body::open_chains(cloth, origin, up)) {
      chains.push_back(seen_from_above(chain));
      for (Vec2& q : chains.back()) q -= middle.head<2>();
    }
    outer = close_along_skin(std::move(chains), inner, most_open, opened);
    if (outer)
      for (Vec2& q : *outer) q += middle.head<2>();
  }
  if (!outer) return {};
  SectionGap section = section_gap(seen_from_above(*skin), *std::move(outer), middle.head<2>());
  section.level = level, section.opened = opened;
  return section;
}

}  // namespace loosefit::maps

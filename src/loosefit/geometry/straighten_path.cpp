#include "loosefit/geometry/straighten_path.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace loosefit::geometry {
namespace {

/// Triangles that are passed one after the other, neighbours across one edge each.
using Strip = std::vector<int>;

struct Portal {
  Vec2 left, right;
  int left_vertex, right_vertex;
};

/// A strip laid flat.
struct Layout {
  std::vector<FlatCorners> corners;  ///< per triangle of the strip
  std::vector<Portal> portals;       ///< between each two
};

int corner_of_edge(const PathSurface& surface, int triangle, int other) {
  for (int j = 0; j < 3; ++j)
    for (int k = 0; k < 3; ++k)
      if (surface.topology().edge(triangle, j) == surface.topology().edge(other, k)) return j;
  return -1;
}

int corner_at(const Triangle& triangle, int vertex) {
  return static_cast<int>(std::find(triangle.begin(), triangle.end(), vertex) - triangle.begin());
}

Layout laid_flat(const PathSurface& surface, const Strip& strip) {
  Layout layout;
  layout.corners.push_back(surface.flat(strip[0]));
  for (std::size_t i = 0; i + 1 < strip.size(); ++i) {
    const Triangle &here = surface.triangles()[strip[i]], &next = surface.triangles()[strip[i + 1]];
    const int k = corner_of_edge(surface, strip[i], strip[i + 1]);
    const int a = here[k], b = here[(k + 1) % 3];
    const FlatCorners& flat = layout.corners[i];
    const Vec2 to = (flat[(k + 1) % 3] - flat[k]).normalized();
    // The way out of a triangle that runs counter-clockwise lies to the right of its edge, so the
    // edge begins to the right of the way.
    const bool turned = cross(to, flat[(k + 2) % 3] - flat[k]) < 0;
    const Vec2 out = turned ? Vec2(-to.y(), to.x()) : Vec2(to.y(), -to.x());
    if (turned)
      layout.portals.push_back({flat[k], flat[(k + 1) % 3], a, b});
    else
      layout.portals.push_back({flat[(k + 1) % 3], flat[k], b, a});
    // The next one from the edge: its own flat corners, turned and moved, its apex beyond.
    const FlatCorners& own = surface.flat(strip[i + 1]);
    const int ja = corner_at(next, a), jb = corner_at(next, b), jc = 3 - ja - jb;
    const Vec2 edge = (own[jb] - own[ja]).normalized(), apex = own[jc] - own[ja];
    const double along = apex.dot(edge), aside = std::abs(cross(edge, apex));
    FlatCorners placed;
    placed[ja] = flat[k];
    placed[jb] = flat[(k + 1) % 3];
    placed[jc] = flat[k] + along * to + aside * out;
    layout.corners.push_back(placed);
  }
  return layout;
}

struct Bend {
  Vec2 at;
  int vertex;  ///< −1: an end of the path
  int portal;  ///< at which it was found; portals.size() for the end
};

double area_of(const Vec2& a, const Vec2& b, const Vec2& c) { return cross(b - a, c - a); }

/// The taut path through the portals (Lee and Preparata 1984): its bends, ends included.
std::vector<Bend> funnel(const Vec2& from, const Vec2& to, const std::vector<Portal>& portals) {
  const int n = static_cast<int>(portals.size());
  std::vector<Bend> bends = {{from, -1, -1}};
  Vec2 apex = from, left = from, right = from;
  int left_at = -1, right_at = -1, left_vertex = -1, right_vertex = -1;
  for (int i = 0; i <= n; ++i) {
    const Vec2 new_left = i < n ? portals[i].left : to, new_right = i < n ? portals[i].right : to;
    const int lv = i < n ? portals[i].left_vertex : -1, rv = i < n ? portals[i].right_vertex : -1;
    const auto restart = [&](const Vec2& at, int vertex, int portal) {
      bends.push_back({at, vertex, portal});
      apex = left = right = at;
      left_vertex = right_vertex = vertex;
      left_at = right_at = portal;
      i = portal;  // goes on behind it
    };
    // Positive: the new point lies to the left of the old line.
    if (area_of(apex, right, new_right) >= 0) {
      if (right == apex || area_of(apex, left, new_right) < 0) {
        right = new_right, right_at = i, right_vertex = rv;
      } else {
        restart(left, left_vertex, left_at);
        continue;
      }
    }
    if (area_of(apex, left, new_left) <= 0) {
      if (left == apex || area_of(apex, right, new_left) > 0) {
        left = new_left, left_at = i, left_vertex = lv;
      } else {
        restart(right, right_vertex, right_at);
        continue;
      }
    }
  }
  bends.push_back({to, -1, n});
  return bends;
}

double angle_at(const FlatCorners& corners, int k) {
  const Vec2 a = corners[(k + 1) % 3] - corners[k], b = corners[(k + 2) % 3] - corners[k];
  return std::atan2(std::abs(cross(a, b)), a.dot(b));
}

class Straightener {
 public:
  Straightener(const PathSurface& surface, const std::vector<char>& inside)
      : surface_(surface), inside_(inside) {}

  SurfacePath run(const SurfacePath& path) {
    Strip strip;
    for (const PathPiece& piece : path)
      if (strip.empty() || strip.back() != piece.triangle) strip.push_back(piece.triangle);
    const Vec3 from = moved_in(path.front().from), to = moved_in(path.back().to);
    // Each turn shortens the path; the bound only ends what round-off would keep going.
    for (int turn = 0; turn < 10000; ++turn) {
      strip = without_detours(strip);
      const Layout layout = laid_flat(surface_, strip);
      const Vec2 start = place(layout.corners.front(), from),
                 end = place(layout.corners.back(), to);
      const std::vector<Bend> bends = funnel(start, end, layout.portals);
      std::optional<Strip> better;
      for (std::size_t b = 1; b + 1 < bends.size() && !better; ++b)
        better = led_round(strip, layout, bends[b - 1], bends[b], bends[b + 1]);
      if (!better) return pieces(strip, layout, bends, from, to);
      strip = std::move(*better);
    }
    return path;
  }

 private:
  static Vec3 moved_in(const Vec3& weights) {
    constexpr double kShare = 1e-6;
    return (1 - kShare) * weights + kShare * Vec3::Constant(1.0 / 3);
  }
  static Vec2 place(const FlatCorners& corners, const Vec3& w) {
    return w[0] * corners[0] + w[1] * corners[1] + w[2] * corners[2];
  }

  /// Without going into a triangle and back out by the same edge.
  static Strip without_detours(const Strip& strip) {
    Strip clean;
    for (const int t : strip) {
      if (clean.size() >= 2 && clean[clean.size() - 2] == t)
        clean.pop_back();
      else
        clean.push_back(t);
    }
    return clean;
  }

  /// The strip led round the other side of the vertex at which it bends, if the surface measures
  /// less than π there.
  std::optional<Strip> led_round(const Strip& strip, const Layout& layout, const Bend& before,
                                 const Bend& bend, const Bend& after) const {
    constexpr double kLess = 1e-9;
    const int v = bend.vertex;
    if (v < 0) return std::nullopt;
    const auto has = [&](int i) {
      const Triangle& t = surface_.triangles()[strip[i]];
      return corner_at(t, v) < 3;
    };
    // Triangles of the strip round the vertex: portal p lies between triangles p and p + 1.
    int first = bend.portal,
        last = std::min<int>(bend.portal + 1, static_cast<int>(strip.size()) - 1);
    while (first > 0 && has(first - 1)) --first;
    while (last + 1 < static_cast<int>(strip.size()) && has(last + 1)) ++last;
    // The other way round, beginning across the other edge of the first one at the vertex.
    Strip fan = {strip[first]};
    double other = 0;
    int across = first + 1 <= last ? edge_between(strip[first], strip[first + 1]) : -1;
    int now = strip[first];
    while (true) {
      const int edge = other_edge(now, v, across);
      const int next = beyond(now, edge);
      if (next < 0 || (!inside_.empty() && !inside_[next])) return std::nullopt;
      fan.push_back(next);
      if (next == strip[last]) break;
      if (fan.size() > surface_.triangles().size()) return std::nullopt;
      other += angle_at(surface_.flat(next), corner_at(surface_.triangles()[next], v));
      now = next;
      across = edge;
    }
    // What of the first and the last triangle lies on that side of the path.
    other += side_angle(layout, strip, first, v, bend, before.at) +
             side_angle(layout, strip, last, v, bend, after.at);
    if (!(other < kPi - kLess)) return std::nullopt;
    Strip led(strip.begin(), strip.begin() + first);
    led.insert(led.end(), fan.begin(), fan.end());
    led.insert(led.end(), strip.begin() + last + 1, strip.end());
    return led;
  }

  /// Angle at the bend between the way to `to` and the edge of triangle i at the vertex that lies
  /// outside of the strip.
  double side_angle(const Layout& layout, const Strip& strip, int i, int v, const Bend& bend,
                    const Vec2& to) const {
    const Triangle& t = surface_.triangles()[strip[i]];
    const int k = corner_at(t, v);
    const FlatCorners& c = layout.corners[i];
    const Vec2 way = to - bend.at;
    // Of its two edges at the vertex the one across which the strip does not go on round it.
    const Vec2 a = c[(k + 1) % 3] - c[k], b = c[(k + 2) % 3] - c[k];
    const bool is_first = i == 0 || !neighbours_round(strip, i - 1, i, v);
    const int into = is_first ? (i + 1 < static_cast<int>(strip.size()) ? i + 1 : -1) : i - 1;
    const int inner = into < 0 ? -1 : edge_between(strip[i], strip[into]);
    const int edge_a = surface_.topology().edge(strip[i], k);  // towards corner k + 1
    const Vec2 outer = inner == edge_a ? b : a;
    return std::atan2(std::abs(cross(way, outer)), way.dot(outer));
  }

  bool neighbours_round(const Strip& strip, int i, int j, int v) const {
    const int edge = edge_between(strip[i], strip[j]);
    const MeshTopology::Edge& ends = surface_.topology().edges()[edge];
    return ends[0] == v || ends[1] == v;
  }

  int edge_between(int t, int u) const {
    return surface_.topology().edge(t, corner_of_edge(surface_, t, u));
  }
  /// The edge of the triangle at the vertex that is not `edge`.
  int other_edge(int triangle, int vertex, int edge) const {
    const int k = corner_at(surface_.triangles()[triangle], vertex);
    const int a = surface_.topology().edge(triangle, k),
              b = surface_.topology().edge(triangle, (k + 2) % 3);
    return a == edge ? b : a;
  }
  int beyond(int triangle, int edge) const {
    for (const MeshTopology::Side& side : surface_.topology().sides(edge))
      if (side.triangle != triangle) return side.triangle;
    return -1;
  }

  SurfacePath pieces(const Strip& strip, const Layout& layout, const std::vector<Bend>& bends,
                     const Vec3& from, const Vec3& to) const {
    constexpr double kNothing = 1e-12;  // [m]
    SurfacePath path;
    std::size_t b = 0;
    PathPiece piece{strip[0], from, from};
    const auto end_piece = [&] {
      if (surface_.length(piece) > kNothing) path.push_back(piece);
    };
    for (int i = 0; i < static_cast<int>(layout.portals.size()); ++i) {
      const Portal& portal = layout.portals[i];
      // The stretch of the taut path that passes this portal.
      while (b + 2 < bends.size() && bends[b + 1].portal < i) ++b;
      const Vec2 way = bends[b + 1].at - bends[b].at, side = portal.left - portal.right;
      const double slope = cross(way, side);
      double share = std::abs(slope) > 0 ? cross(bends[b].at - portal.right, way) / -slope : 0;
      if (bends[b + 1].portal == i && bends[b + 1].vertex >= 0)
        share = bends[b + 1].vertex == portal.left_vertex ? 1 : 0;
      else if (bends[b].vertex == portal.left_vertex && b > 0)
        share = 1;
      else if (bends[b].vertex == portal.right_vertex && b > 0)
        share = 0;
      share = std::clamp(share, 0.0, 1.0);
      const auto weights = [&](int triangle) {
        const Triangle& t = surface_.triangles()[triangle];
        Vec3 w = Vec3::Zero();
        w[corner_at(t, portal.left_vertex)] = share;
        w[corner_at(t, portal.right_vertex)] = 1 - share;
        return w;
      };
      piece.to = weights(strip[i]);
      end_piece();
      piece = {strip[i + 1], weights(strip[i + 1]), Vec3::Zero()};
    }
    piece.to = to;
    end_piece();
    return path;
  }

  const PathSurface& surface_;
  const std::vector<char>& inside_;
};

}  // namespace

SurfacePath straighten_path(const PathSurface& surface, const SurfacePath& path,
                            const std::vector<char>& inside) {
  if (path.empty()) return path;
  return Straightener(surface, inside).run(path);
}

}  // namespace loosefit::geometry

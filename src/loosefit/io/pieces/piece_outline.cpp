#include "loosefit/io/pieces/piece_outline.h"

#include <algorithm>
#include <cmath>

#include "loosefit/geometry/flat_triangle.h"

namespace loosefit::io {
namespace {

constexpr double kKinkAtTurnPoint = 20, kKink = 40;  // [degrees]
constexpr double kShortestFold = 0.01;               // along the mirror line [m]

/// How much a way turns at b, from 0 to 180 degrees.
double turn_deg(const Vec2& a, const Vec2& b, const Vec2& c) {
  const Vec2 u = b - a, v = c - b;
  return degrees(std::atan2(std::abs(geometry::cross(u, v)), u.dot(v)));
}

bool near_any(const std::vector<Vec2>& points, const Vec2& p) {
  return std::any_of(points.begin(), points.end(),
                     [&](const Vec2& q) { return (p - q).norm() < kChainGap; });
}

/// \param inner points inside a line that is one edge, which are no corners
void mark_kinks(Outline& loop, const std::vector<bool>& inner,
                const std::vector<Vec2>& turn_points) {
  const std::size_t n = loop.size();
  for (std::size_t i = 0; i < n; ++i) {
    if (inner[i]) continue;
    // Over a point that is repeated the turn is undefined: look at the next different ones.
    std::size_t before = (i + n - 1) % n, after = (i + 1) % n;
    while (before != i && (loop[before].at - loop[i].at).norm() < kSamePoint)
      before = (before + n - 1) % n;
    while (after != i && (loop[after].at - loop[i].at).norm() < kSamePoint) after = (after + 1) % n;
    if (before == i || after == i) continue;
    const double turn = turn_deg(loop[before].at, loop[i].at, loop[after].at);
    if (turn_points.empty() ? turn > kKink
                            : turn > kKinkAtTurnPoint && near_any(turn_points, loop[i].at))
      loop[i].corner = true;
  }
}

}  // namespace

double outline_area(const Outline& loop) {
  double twice = 0;
  for (std::size_t i = 0; i < loop.size(); ++i)
    twice += geometry::cross(loop[i].at, loop[(i + 1) % loop.size()].at);
  return twice / 2;
}

Chained chain_lines(const std::vector<DrawnLine>& lines, const std::vector<Vec2>& turn_points) {
  Chained result;
  std::vector<bool> used(lines.size(), false);
  const auto take_loop = [&](Outline loop, const std::vector<bool>& inner) {
    mark_kinks(loop, inner, turn_points);
    result.loops.push_back(std::move(loop));
  };
  for (std::size_t first = 0; first < lines.size(); ++first) {
    if (used[first] || lines[first].points.size() < 2) continue;
    used[first] = true;
    Outline chain;
    for (const Vec2& p : lines[first].points) chain.push_back({p});
    const auto ends_meet = [&] {
      return (chain.front().at - chain.back().at).norm() < kChainGap && chain.size() > 3;
    };
    std::vector<bool> inner(chain.size(), false);
    if (lines[first].closed) {
      take_loop(std::move(chain), inner);
      continue;
    }
    bool edge = lines[first].one_edge;
    // A single line that comes back to its start is as one that is marked closed.
    chain.front().corner = edge && !ends_meet();
    if (ends_meet()) edge = false;
    if (edge) std::fill(inner.begin() + 1, inner.end() - 1, true);
    while (!ends_meet()) {
      // The line that goes on from here; of several the next one in the file.
      std::size_t next = lines.size();
      bool backwards = false;
      for (std::size_t k = 1; k < lines.size() && next == lines.size(); ++k) {
        const std::size_t i = (first + k) % lines.size();
        if (used[i] || lines[i].closed || lines[i].points.size() < 2) continue;
        const bool starts = (lines[i].points.front() - chain.back().at).norm() < kChainGap;
        const bool ends = (lines[i].points.back() - chain.back().at).norm() < kChainGap;
        if (starts || ends) next = i, backwards = !starts;
      }
      if (next == lines.size()) break;
      used[next] = true;
      std::vector<Vec2> points = lines[next].points;
      if (backwards) std::reverse(points.begin(), points.end());
      chain.back().corner = edge || lines[next].one_edge;
      edge = lines[next].one_edge;
      for (std::size_t i = 1; i < points.size(); ++i) {
        chain.push_back({points[i]});
        inner.push_back(edge && i + 1 < points.size());
      }
    }
    if (ends_meet()) {
      chain.front().corner = chain.front().corner || edge;
      chain.pop_back();
      take_loop(std::move(chain), inner);
      continue;
    }
    if (std::all_of(chain.begin(), chain.end(), [&](const OutlinePoint& p) {
          return (p.at - chain.front().at).norm() < kChainGap;
        }))
      continue;  // a line of no length
    const double area = std::abs(outline_area(chain));
    if (result.open == 0 || area > result.open_area) {
      result.open_area = area;
      result.gap = (chain.front().at - chain.back().at).norm();
      result.gap_at = chain.back().at;
    }
    ++result.open;
  }
  std::stable_sort(result.loops.begin(), result.loops.end(), [](const auto& a, const auto& b) {
    return std::abs(outline_area(a)) > std::abs(outline_area(b));
  });
  return result;
}

Outline cleaned(Outline loop) {
  struct Ordered {
    OutlinePoint point;
    std::size_t order;  ///< in the file, so that edges are counted from the same place
  };
  std::vector<Ordered> points;
  for (std::size_t i = 0; i < loop.size(); ++i) points.push_back({loop[i], i});
  // Points that repeat and tips of ways out and back go until none is left. The list is turned by
  // half between rounds, so that what lies over its end is seen too.
  for (int quiet = 0; quiet < 2 && points.size() >= 3;) {
    const std::size_t before = points.size();
    std::vector<Ordered> kept;
    for (Ordered p : points) {
      while (!kept.empty()) {
        const Ordered last = kept.back();
        if ((last.point.at - p.point.at).norm() < kSamePoint) {
          p.point = {last.point.at, p.point.corner || last.point.corner};
          p.order = std::min(p.order, last.order);
          kept.pop_back();
          continue;
        }
        if (kept.size() < 2) break;
        const Vec2 out = last.point.at - kept[kept.size() - 2].point.at;
        const Vec2 back = p.point.at - last.point.at;
        const bool reversed =
            out.dot(back) < 0 &&
            std::abs(geometry::cross(out, back)) < kSamePoint * std::max(out.norm(), back.norm());
        if (!reversed) break;
        kept.pop_back();
      }
      kept.push_back(p);
    }
    quiet = kept.size() == before ? quiet + 1 : 0;
    std::rotate(kept.begin(), kept.begin() + static_cast<std::ptrdiff_t>(kept.size() / 2),
                kept.end());
    points = std::move(kept);
  }
  const auto first = std::min_element(
      points.begin(), points.end(), [](const auto& a, const auto& b) { return a.order < b.order; });
  std::rotate(points.begin(), first, points.end());
  loop.clear();
  for (const Ordered& p : points) loop.push_back(p.point);
  if (loop.size() < 3 || outline_area(loop) == 0) return {};
  if (outline_area(loop) < 0) std::reverse(loop.begin() + 1, loop.end());
  // A panel has at least two edges.
  std::vector<std::size_t> corners;
  for (std::size_t i = 0; i < loop.size(); ++i)
    if (loop[i].corner) corners.push_back(i);
  if (corners.empty()) loop[0].corner = true, corners = {0};
  if (corners.size() == 1) loop[(corners[0] + loop.size() / 2) % loop.size()].corner = true;
  // The first edge begins with the first point.
  const auto begin = std::find_if(loop.begin(), loop.end(), [](const auto& p) { return p.corner; });
  std::rotate(loop.begin(), begin, loop.end());
  return loop;
}

namespace {

/// Part of an outline from the end of one run on an axis to the begin of the next, and its image.
Outline with_image(Outline half, const Vec2& a, const Vec2& across) {
  const auto mirrored = [&](const Vec2& p) -> Vec2 { return p - 2 * across.dot(p - a) * across; };
  // Other points on the axis come to lie on their own images: a piece that hangs together by a
  // point is then refused as one that crosses itself.
  for (OutlinePoint& p : half)
    if (const double off = across.dot(p.at - a); std::abs(off) < kOnAxis) p.at -= off * across;
  half.front().corner = half.back().corner = false;
  Outline whole = half;
  for (std::size_t i = half.size() - 2; i > 0; --i)
    whole.push_back({mirrored(half[i].at), half[i].corner});
  const std::size_t fold = half.size() - 1, m = whole.size();
  whole[0].corner = turn_deg(whole[m - 1].at, whole[0].at, whole[1].at) > kKinkAtTurnPoint;
  whole[fold].corner =
      turn_deg(whole[fold - 1].at, whole[fold].at, whole[(fold + 1) % m].at) > kKinkAtTurnPoint;
  return whole;
}

}  // namespace

Fold unfold(Outline& loop, const Vec2& a, const Vec2& b, std::vector<Outline>& holes) {
  const Vec2 along = (b - a).normalized(), across(-along.y(), along.x());
  if (!along.allFinite() || loop.size() < 3) return Fold::beside;
  const std::size_t n = loop.size();
  const auto height = [&](std::size_t i) { return across.dot(loop[i % n].at - a); };
  double low = 0, high = 0;
  for (std::size_t i = 0; i < n; ++i)
    low = std::min(low, height(i)), high = std::max(high, height(i));
  if (low < -kOnAxis && high > kOnAxis) return Fold::whole;
  // Runs of points on the axis, by their first and last ones, in the order of the outline.
  const auto on_axis = [&](std::size_t i) { return std::abs(height(i)) < kOnAxis; };
  std::vector<std::pair<std::size_t, std::size_t>> runs;
  for (std::size_t i = 0; i < n; ++i) {
    if (!on_axis(i) || on_axis(i + n - 1)) continue;  // a run begins here
    std::size_t end = i;
    while (end - i < n && on_axis(end + 1)) ++end;
    if ((loop[end % n].at - loop[i].at).norm() >= kShortestFold) runs.emplace_back(i, end);
  }
  if (runs.empty()) return Fold::beside;
  // What leads from the end of a run to the begin of the next closes with its image. The largest is
  // the outline, the others go round holes.
  std::vector<Outline> closed;
  for (std::size_t k = 0; k < runs.size(); ++k) {
    const std::size_t last = k + 1 < runs.size() ? runs[k + 1].first : runs[0].first + n;
    Outline half;
    for (std::size_t i = runs[k].second; i <= last; ++i) half.push_back(loop[i % n]);
    if (half.size() > 2) closed.push_back(with_image(std::move(half), a, across));
  }
  if (closed.empty()) return Fold::beside;
  const auto largest =
      std::max_element(closed.begin(), closed.end(), [](const Outline& p, const Outline& q) {
        return std::abs(outline_area(p)) < std::abs(outline_area(q));
      });
  loop = std::move(*largest);
  closed.erase(largest);
  for (Outline& hole : closed) holes.push_back(std::move(hole));
  return Fold::unfolded;
}

}  // namespace loosefit::io

#include "loosefit/geometry/path_graph.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <tuple>

namespace loosefit::geometry {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// Barycentric place in `triangle` of a point of one of its edges, `share` from the lower vertex.
Vec3 on_edge(const PathSurface& surface, int triangle, int corner, double share) {
  const Triangle& v = surface.triangles()[triangle];
  const int next = (corner + 1) % 3;
  if (v[corner] > v[next]) share = 1 - share;
  Vec3 weights = Vec3::Zero();
  weights[corner] = 1 - share;
  weights[next] = share;
  return weights;
}

/// The search: nodes are `points` places on every edge.
class Search {
 public:
  Search(const PathSurface& surface, const PieceCost& cost, const CrossingCost& crossing,
         int points)
      : surface_(surface), cost_(cost), crossing_(crossing), points_(points) {
    const auto nodes = static_cast<std::size_t>(surface.topology().edge_count()) * points;
    reached_.assign(nodes, {});
  }

  std::optional<SurfacePath> run(const SurfacePoint& from, const SurfacePoint& to) {
    double best = kInfinite;
    int last = -1;  // node before the end; −1 is the begin
    if (from.triangle == to.triangle)
      best = cost_({from.triangle, from.barycentric, to.barycentric});
    spread(-1, 0, from.triangle, from.barycentric);
    while (!queue_.empty()) {
      const auto [cost, node] = queue_.top();
      queue_.pop();
      if (cost >= best) break;
      if (cost > reached_[node].cost) continue;
      const int edge = node / points_;
      const double over = crossing_ ? crossing_(edge) : 0;
      for (const MeshTopology::Side& side : surface_.topology().sides(edge)) {
        if (side.triangle == reached_[node].triangle || !(over < kInfinite)) continue;
        const Vec3 here = on_edge(surface_, side.triangle, side.corner, share(node));
        if (side.triangle == to.triangle) {
          const double whole = cost + over + cost_({side.triangle, here, to.barycentric});
          if (whole < best) best = whole, last = node;
        }
        spread(node, cost + over, side.triangle, here);
      }
    }
    if (!(best < kInfinite)) return std::nullopt;
    return traced(from, to, last);
  }

 private:
  struct Reached {
    double cost = kInfinite;
    int before = -1;    ///< node; −1: the begin
    int triangle = -1;  ///< through which it was reached
  };

  double share(int node) const { return (node % points_ + 0.5) / points_; }

  /// All nodes of a triangle from a place on its border or inside.
  void spread(int before, double cost, int triangle, const Vec3& here) {
    const int own = before < 0 ? -1 : before / points_;
    for (int corner = 0; corner < 3; ++corner) {
      const int edge = surface_.topology().edge(triangle, corner);
      if (edge == own || surface_.topology().sides(edge).size() < 2) continue;
      for (int k = 0; k < points_; ++k) {
        const int node = edge * points_ + k;
        if (reached_[node].cost <= cost) continue;
        const double whole =
            cost + cost_({triangle, here, on_edge(surface_, triangle, corner, share(node))});
        if (!(whole < reached_[node].cost)) continue;
        reached_[node] = {whole, before, triangle};
        queue_.emplace(whole, node);
      }
    }
  }

  Vec3 place(int triangle, int node) const {
    for (int corner = 0; corner < 3; ++corner)
      if (surface_.topology().edge(triangle, corner) == node / points_)
        return on_edge(surface_, triangle, corner, share(node));
    return Vec3::Zero();
  }

  SurfacePath traced(const SurfacePoint& from, const SurfacePoint& to, int last) const {
    SurfacePath path;
    int triangle = to.triangle;
    Vec3 end = to.barycentric;
    for (int node = last; node >= 0; node = reached_[node].before) {
      path.push_back({triangle, place(triangle, node), end});
      triangle = reached_[node].triangle;
      end = place(triangle, node);
    }
    path.push_back({triangle, from.barycentric, end});
    std::reverse(path.begin(), path.end());
    return path;
  }

  const PathSurface& surface_;
  const PieceCost& cost_;
  const CrossingCost& crossing_;
  int points_;
  std::vector<Reached> reached_;
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue_;
};

/// Least of a function between 0 and 1 by golden sections, near `start`, which stays where nothing
/// is lower.
double lowest_share(const std::function<double(double)>& value, double start) {
  constexpr double kGolden = 0.6180339887498949;
  constexpr double kNarrow = 1e-6;
  double low = 0, high = 1;
  double a = high - kGolden * (high - low), b = low + kGolden * (high - low);
  double at_a = value(a), at_b = value(b);
  while (high - low > kNarrow) {
    if (at_a <= at_b) {
      high = b, b = a, at_b = at_a;
      a = high - kGolden * (high - low), at_a = value(a);
    } else {
      low = a, a = b, at_a = at_b;
      b = low + kGolden * (high - low), at_b = value(b);
    }
  }
  const double found = 0.5 * (low + high);
  return value(found) < value(start) ? found : start;
}

}  // namespace

std::optional<SurfacePath> cheapest_path(const PathSurface& surface, const SurfacePoint& from,
                                         const SurfacePoint& to, const PieceCost& cost,
                                         const CrossingCost& crossing, int points) {
  return Search(surface, cost, crossing, points).run(from, to);
}

SurfacePath refine_crossings(const PathSurface& surface, SurfacePath path, const PieceCost& cost,
                             double tolerance, int sweeps) {
  /// Edge between piece i and piece i + 1, by its corner in both triangles.
  struct Crossing {
    int before, after;
  };
  std::vector<Crossing> crossings;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    Crossing crossing{-1, -1};
    for (int j = 0; j < 3; ++j)
      for (int k = 0; k < 3; ++k)
        if (surface.topology().edge(path[i].triangle, j) ==
            surface.topology().edge(path[i + 1].triangle, k))
          crossing = {j, k};
    crossings.push_back(crossing);
  }
  const auto share_of = [&](std::size_t i) {
    const Triangle& v = surface.triangles()[path[i].triangle];
    const int k = crossings[i].before, next = (k + 1) % 3;
    return path[i].to[v[k] < v[next] ? next : k];
  };
  const auto moved = [&](std::size_t i, double share) {
    path[i].to = on_edge(surface, path[i].triangle, crossings[i].before, share);
    path[i + 1].from = on_edge(surface, path[i + 1].triangle, crossings[i].after, share);
  };
  double whole = 0;
  for (const PathPiece& piece : path) whole += cost(piece);
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    double gained = 0;
    for (std::size_t k = 0; k < crossings.size(); ++k) {
      const std::size_t i = sweep % 2 == 0 ? k : crossings.size() - 1 - k;
      if (crossings[i].before < 0) continue;  // a stop on the way, not an edge
      const auto value = [&](double share) {
        moved(i, share);
        return cost(path[i]) + cost(path[i + 1]);
      };
      const double start = share_of(i), before = value(start);
      const double share = lowest_share(value, start);
      gained += before - value(share);
    }
    if (!(gained > tolerance * whole)) break;
  }
  return path;
}

}  // namespace loosefit::geometry

#include "loosefit/body/mesh_repair.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include "loosefit/base/union_find.h"
#include "loosefit/geometry/mesh_topology.h"

namespace loosefit::body {
namespace {

// Asked for edges and counts of sides alone, which hold for broken surfaces too.
using geometry::MeshTopology;
using Edge = MeshTopology::Edge;

Edge edge_of(int a, int b) { return {std::min(a, b), std::max(a, b)}; }

bool degenerate(const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; }

/// Vertices of open edges grouped by place: an equal number for those within `distance`.
std::map<int, int> places_of(const geometry::TriangleMesh& mesh, const std::vector<Edge>& open,
                             double distance) {
  std::vector<int> vertices;
  for (const auto& e : open) vertices.insert(vertices.end(), e.begin(), e.end());
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  // A grid of cells as wide as the distance: near vertices are in neighbouring cells.
  using Cell = std::array<long long, 3>;
  std::map<Cell, std::vector<int>> cells;
  const auto cell_of = [&](int v) {
    const Vec3 p = mesh.vertices[std::size_t(v)] / distance;
    return Cell{std::llround(p.x()), std::llround(p.y()), std::llround(p.z())};
  };
  for (std::size_t i = 0; i < vertices.size(); ++i) cells[cell_of(vertices[i])].push_back(int(i));
  // Join what is near; the number of the set is the place.
  UnionFind sets(vertices.size());
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Vec3& p = mesh.vertices[std::size_t(vertices[i])];
    const Cell at = cell_of(vertices[i]);
    for (int step = 0; step < 27; ++step) {
      const auto near =
          cells.find({at[0] + step % 3 - 1, at[1] + step / 3 % 3 - 1, at[2] + step / 9 - 1});
      if (near == cells.end()) continue;
      for (const int other : near->second) {
        const Vec3& q = mesh.vertices[std::size_t(vertices[std::size_t(other)])];
        if ((p - q).norm() <= distance) sets.unite(int(i), other);
      }
    }
  }
  std::map<int, int> place;
  for (std::size_t i = 0; i < vertices.size(); ++i) place[vertices[i]] = sets.find(int(i));
  return place;
}

/// Least-area triangulation of a ring by dynamic programming; empty when every one needs an edge
/// that the surface has already.
std::vector<Triangle> least_area_span(const geometry::TriangleMesh& mesh,
                                      const std::vector<int>& rim, const MeshTopology& topology) {
  constexpr double kNever = std::numeric_limits<double>::infinity();
  const std::size_t n = rim.size();
  // cost[i][k]: least area over the part of the rim from i to k; apex[i][k]: third corner of the
  // triangle on that chord.
  std::vector<std::vector<double>> cost(n, std::vector<double>(n, 0));
  std::vector<std::vector<std::size_t>> apex(n, std::vector<std::size_t>(n, 0));
  const auto at = [&](std::size_t i) -> const Vec3& { return mesh.vertices[std::size_t(rim[i])]; };
  for (std::size_t gap = 2; gap < n; ++gap) {
    for (std::size_t i = 0; i + gap < n; ++i) {
      const std::size_t k = i + gap;
      cost[i][k] = kNever;
      const bool chord = gap < n - 1;
      if (chord && topology.find(rim[i], rim[k]) >= 0) continue;
      for (std::size_t m = i + 1; m < k; ++m) {
        const double area = cost[i][m] + cost[m][k] + geometry::triangle_area(at(i), at(m), at(k));
        if (area < cost[i][k]) cost[i][k] = area, apex[i][k] = m;
      }
    }
  }
  // Read the triangles off from the whole rim downwards.
  std::vector<Triangle> span;
  if (cost[0][n - 1] == kNever) return span;
  const std::function<void(std::size_t, std::size_t)> emit = [&](std::size_t i, std::size_t k) {
    if (k - i < 2) return;
    const std::size_t m = apex[i][k];
    span.push_back({rim[i], rim[m], rim[k]});
    emit(i, m);
    emit(m, k);
  };
  emit(0, n - 1);
  return span;
}

}  // namespace

int drop_unused_vertices(geometry::TriangleMesh& mesh) {
  std::vector<int> number(mesh.vertices.size(), -1);
  for (const auto& t : mesh.triangles) {
    for (const int corner : t) number[std::size_t(corner)] = 0;
  }
  std::vector<Vec3> kept;
  for (std::size_t v = 0; v < number.size(); ++v) {
    if (number[v] < 0) continue;
    number[v] = int(kept.size());
    kept.push_back(mesh.vertices[v]);
  }
  for (auto& t : mesh.triangles) {
    for (auto& corner : t) corner = number[std::size_t(corner)];
  }
  const int dropped = int(mesh.vertices.size() - kept.size());
  mesh.vertices = std::move(kept);
  return dropped;
}

int drop_repeated_triangles(geometry::TriangleMesh& mesh) {
  std::set<Triangle> seen;
  return int(std::erase_if(mesh.triangles, [&](Triangle t) {
    std::sort(t.begin(), t.end());
    return !seen.insert(t).second;
  }));
}

void weld_seams(geometry::TriangleMesh& mesh, double distance) {
  const MeshTopology before(mesh.triangles);
  // Open edges, grouped by the places of their ends.
  std::vector<Edge> open;
  for (int e = 0; e < before.edge_count(); ++e) {
    if (before.sides(e).size() == 1) open.push_back(before.edges()[std::size_t(e)]);
  }
  if (open.empty()) return;
  const std::map<int, int> place = places_of(mesh, open, distance);
  std::map<Edge, std::vector<Edge>> together;  // open edges by the places of their ends
  for (const auto& e : open) {
    if (place.at(e[0]) != place.at(e[1]))
      together[edge_of(place.at(e[0]), place.at(e[1]))].push_back(e);
  }
  std::set<int> apart;  // places where uniting would crowd an edge
  std::vector<int> target(mesh.vertices.size());
  for (bool crowded = true; crowded;) {
    crowded = false;
    // Unite the ends of edges that lie together.
    UnionFind sets(mesh.vertices.size());
    for (const auto& [ends, edges] : together) {
      if (edges.size() < 2) continue;
      for (std::size_t i = 1; i < edges.size(); ++i) {
        for (const int a : edges[0]) {
          for (const int b : edges[i]) {
            if (place.at(a) == place.at(b) && !apart.count(place.at(a))) sets.unite(a, b);
          }
        }
      }
    }
    for (std::size_t v = 0; v < target.size(); ++v) target[v] = sets.find(int(v));
    // How the surface would look then: an edge of more than two triangles shows places that must
    // stay apart, and the round begins again.
    std::vector<Triangle> united;
    for (const auto& t : mesh.triangles) {
      const Triangle moved = {target[std::size_t(t[0])], target[std::size_t(t[1])],
                              target[std::size_t(t[2])]};
      if (!degenerate(moved)) united.push_back(moved);
    }
    std::set<Edge> already;
    for (int e = 0; e < before.edge_count(); ++e) {
      const Edge& edge = before.edges()[std::size_t(e)];
      if (before.sides(e).size() > 2)
        already.insert(edge_of(target[std::size_t(edge[0])], target[std::size_t(edge[1])]));
    }
    const MeshTopology after(std::move(united));
    for (int e = 0; e < after.edge_count(); ++e) {
      const Edge& edge = after.edges()[std::size_t(e)];
      if (after.sides(e).size() <= 2 || already.count(edge)) continue;
      for (const int end : edge) {
        const auto found = place.find(end);
        if (found != place.end() && apart.insert(found->second).second) crowded = true;
      }
    }
  }
  // Carry it out.
  for (auto& t : mesh.triangles) {
    for (auto& corner : t) corner = target[std::size_t(corner)];
  }
  std::erase_if(mesh.triangles, degenerate);
  drop_unused_vertices(mesh);
}

std::vector<Hole> find_holes(const geometry::TriangleMesh& mesh) {
  const MeshTopology topology(mesh.triangles);
  std::map<int, std::vector<int>> next;  // along the rim, against the triangle's own direction
  for (int i = 0; i < int(mesh.triangles.size()); ++i) {
    const Triangle& t = mesh.triangles[std::size_t(i)];
    for (int c = 0; c < 3; ++c) {
      const int a = t[std::size_t(c)], b = t[std::size_t((c + 1) % 3)];
      if (topology.sides(topology.edge(i, c)).size() == 1) next[b].push_back(a);
    }
  }
  std::vector<Hole> holes;
  for (auto& [start, ways] : next) {
    while (!ways.empty()) {
      // A walk that meets itself has gone round a hole; what led there goes on.
      std::vector<int> walk = {start};
      while (!walk.empty()) {
        auto& onward = next[walk.back()];
        if (onward.empty()) break;
        const int to = onward.back();
        onward.pop_back();
        const auto met = std::find(walk.begin(), walk.end(), to);
        if (met == walk.end()) {
          walk.push_back(to);
          continue;
        }
        Hole hole;
        hole.rim.assign(met, walk.end());
        walk.erase(met + 1, walk.end());
        if (hole.rim.size() >= 3) holes.push_back(std::move(hole));
      }
    }
  }
  // Centre and width of each, the widest first.
  for (auto& hole : holes) {
    for (const int v : hole.rim) hole.centre += mesh.vertices[std::size_t(v)];
    hole.centre /= double(hole.rim.size());
    for (const int a : hole.rim) {
      for (const int b : hole.rim)
        hole.width = std::max(
            hole.width, (mesh.vertices[std::size_t(a)] - mesh.vertices[std::size_t(b)]).norm());
    }
  }
  std::stable_sort(holes.begin(), holes.end(),
                   [](const Hole& a, const Hole& b) { return a.width > b.width; });
  return holes;
}

void fill_hole(geometry::TriangleMesh& mesh, const Hole& hole) {
  constexpr std::size_t kLongRim = 120;
  if (hole.rim.size() <= kLongRim) {
    const auto span = least_area_span(mesh, hole.rim, MeshTopology(mesh.triangles));
    if (!span.empty()) {
      mesh.triangles.insert(mesh.triangles.end(), span.begin(), span.end());
      return;
    }
  }
  const int middle = int(mesh.vertices.size());
  mesh.vertices.push_back(hole.centre);
  for (std::size_t i = 0; i < hole.rim.size(); ++i)
    mesh.triangles.push_back({hole.rim[i], hole.rim[(i + 1) % hole.rim.size()], middle});
}

}  // namespace loosefit::body

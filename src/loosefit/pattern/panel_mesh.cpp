#include "loosefit/pattern/panel_mesh.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "loosefit/base/check.h"
#include "loosefit/geometry/flat_triangle.h"
#include "loosefit/geometry/mesh_topology.h"
#include "loosefit/pattern/hole.h"
#include "loosefit/pattern/outline.h"

namespace loosefit::pattern {

double smallest_angle(const Vec2& a, const Vec2& b, const Vec2& c) {
  double smallest = kPi;
  const Vec2 corner[3] = {a, b, c};
  for (int i = 0; i < 3; ++i) {
    const Vec2 u = corner[(i + 1) % 3] - corner[i], v = corner[(i + 2) % 3] - corner[i];
    smallest = std::min(smallest, std::atan2(geometry::cross(u, v), u.dot(v)));
  }
  return smallest;
}

MeshQuality mesh_quality(const PanelMesh& mesh) {
  MeshQuality quality;
  double edges = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vec2 &p = mesh.vertices[a], &q = mesh.vertices[b], &r = mesh.vertices[c];
    const double angle = smallest_angle(p, q, r);
    quality.smallest_angle = std::min(quality.smallest_angle, angle);
    quality.mean_angle += angle;
    edges += (q - p).norm() + (r - q).norm() + (p - r).norm();
  }
  const double n = std::max<std::size_t>(mesh.triangles.size(), 1);
  quality.mean_angle /= n;
  quality.mean_edge = edges / n / 3;
  return quality;
}

PanelMesh subdivide(const PanelMesh& coarse, const Panel& panel,
                    std::vector<std::array<int, 2>>& parents) {
  PanelMesh fine;
  fine.vertices = coarse.vertices;
  parents.clear();
  for (int i = 0; i < static_cast<int>(coarse.vertices.size()); ++i) parents.push_back({i, i});
  const geometry::MeshTopology topology(coarse.triangles);
  std::vector<int> middle_of(topology.edges().size(), -1);
  // A new vertex in the middle of every edge, numbered as the triangles meet them.
  const auto middle = [&](int triangle, int corner) {
    const int edge = topology.edge(triangle, corner);
    if (middle_of[edge] < 0) {
      middle_of[edge] = static_cast<int>(fine.vertices.size());
      const auto& [low, high] = topology.edges()[edge];
      fine.vertices.push_back((coarse.vertices[low] + coarse.vertices[high]) / 2);
      parents.push_back({low, high});
    }
    return middle_of[edge];
  };
  // Four triangles for one.
  for (int t = 0; t < static_cast<int>(coarse.triangles.size()); ++t) {
    const auto& [a, b, c] = coarse.triangles[t];
    const int ab = middle(t, 0), bc = middle(t, 1), ca = middle(t, 2);
    fine.triangles.push_back({a, ab, ca});
    fine.triangles.push_back({b, bc, ab});
    fine.triangles.push_back({c, ca, bc});
    fine.triangles.push_back({ab, bc, ca});
  }
  // Middles of outline edges go onto the curve, half way along the arc.
  std::vector<Vec2> on_curve = fine.vertices;
  std::vector<bool> moved(fine.vertices.size(), false);
  for (std::size_t e = 0; e < coarse.edge_vertices.size(); ++e) {
    const std::vector<int>& chain = coarse.edge_vertices[e];
    const EdgePath path(panel, static_cast<int>(e));
    const int segments = static_cast<int>(chain.size()) - 1;
    std::vector<int> finer{chain[0]};
    for (int i = 0; i < segments; ++i) {
      const int edge = topology.find(chain[i], chain[i + 1]);
      require(edge >= 0, "the outline of a panel runs along edges of its mesh");
      const int m = middle_of[edge];
      on_curve[m] = path.at((i + 0.5) / segments);
      moved[m] = true;
      finer.push_back(m);
      finer.push_back(chain[i + 1]);
    }
    fine.edge_vertices.push_back(finer);
  }
  for (std::size_t h = 0; h < coarse.holes.size(); ++h) {
    const PanelHole& hole = panel.holes[h];
    const double length = rim_length(hole);
    const auto& [chain, along] = coarse.holes[h];
    MeshedRim finer;
    for (std::size_t i = 0; i < chain.size(); ++i) {
      const bool last = i + 1 == chain.size();
      const int edge = topology.find(chain[i], chain[last ? 0 : i + 1]);
      require(edge >= 0, "the rim of a hole runs along edges of its mesh");
      const int m = middle_of[edge];
      const double between = 0.5 * (along[i] + (last ? along[0] + length : along[i + 1]));
      on_curve[m] = point_on_rim(hole, between);
      moved[m] = true;
      finer.vertices.insert(finer.vertices.end(), {chain[i], m});
      finer.along.insert(finer.along.end(), {along[i], between});
    }
    fine.holes.push_back(std::move(finer));
  }
  // A curve that bulges further than its triangle is deep keeps the chord's midpoint.
  const std::vector<Vec2> chord = std::exchange(fine.vertices, on_curve);
  for (bool again = true; again;) {
    again = false;
    for (const Triangle& t : fine.triangles) {
      if (smallest_angle(fine.vertices[t[0]], fine.vertices[t[1]], fine.vertices[t[2]]) > 0.05)
        continue;
      for (const int v : t)
        if (moved[v]) fine.vertices[v] = chord[v], moved[v] = false, again = true;
    }
  }
  return fine;
}

}  // namespace loosefit::pattern

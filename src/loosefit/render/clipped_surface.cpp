#include "loosefit/render/clipped_surface.h"

#include <algorithm>
#include <map>

namespace loosefit::render {

ClippedSurface clipped(const geometry::TriangleMesh& mesh, const std::vector<double>& keep) {
  ClippedSurface result;
  geometry::TriangleMesh& part = result.mesh;
  std::vector<int> kept(mesh.vertices.size(), -1);
  // Of the few edges that are cut; a MeshTopology of every piece would sort all of its edges.
  std::map<std::pair<int, int>, int> split;
  // Vertices of the part: kept ones once each, and one on every edge that is cut.
  const auto add = [&](const Vec3& p, int origin) {
    part.vertices.push_back(p);
    result.origin.push_back(origin);
    return static_cast<int>(part.vertices.size()) - 1;
  };
  const auto old_vertex = [&](int v) {
    if (kept[v] < 0) kept[v] = add(mesh.vertices[v], v);
    return kept[v];
  };
  const auto new_vertex = [&](int a, int b) {
    const auto [place, is_new] = split.try_emplace(std::minmax(a, b), -1);
    if (is_new) {
      const double share = keep[a] / (keep[a] - keep[b]);
      place->second = add(mesh.vertices[a] + share * (mesh.vertices[b] - mesh.vertices[a]),
                          keep[a] >= 0 ? a : b);
    }
    return place->second;
  };
  // Walk round each triangle: what is left of it is a polygon of up to four corners.
  for (const Triangle& t : mesh.triangles) {
    std::vector<int> corners, cut;
    for (int k = 0; k < 3; ++k) {
      const int a = t[k], b = t[(k + 1) % 3];
      if (keep[a] >= 0) corners.push_back(old_vertex(a));
      if ((keep[a] >= 0) != (keep[b] >= 0)) {
        corners.push_back(new_vertex(a, b));
        cut.push_back(corners.back());
      }
    }
    // Cut into a fan; the two new corners are a piece of the rim.
    for (std::size_t k = 2; k < corners.size(); ++k)
      part.triangles.push_back({corners[0], corners[k - 1], corners[k]});
    if (cut.size() == 2) result.rim.push_back({cut[0], cut[1]});
  }
  return result;
}

void close_with_fan(geometry::TriangleMesh& mesh, const std::vector<std::array<int, 2>>& rim,
                    const Vec3& outwards) {
  if (rim.empty()) return;
  Vec3 centre = Vec3::Zero();
  for (const auto& [i, j] : rim) centre += 0.5 * (mesh.vertices[i] + mesh.vertices[j]);
  centre /= static_cast<double>(rim.size());
  for (const auto& [i, j] : rim) {
    const int first = static_cast<int>(mesh.vertices.size());
    const Vec3 a = mesh.vertices[i], b = mesh.vertices[j];
    mesh.vertices.insert(mesh.vertices.end(), {centre, a, b});
    const bool flip = geometry::triangle_normal(centre, a, b).dot(outwards) < 0;
    mesh.triangles.push_back({first, first + (flip ? 2 : 1), first + (flip ? 1 : 2)});
  }
}

}  // namespace loosefit::render

#include "loosefit/render/smooth_solid.h"

#include <algorithm>
#include <limits>
#include <map>
#include <optional>

#include "loosefit/geometry/convex_hull.h"
#include "loosefit/geometry/mesh_topology.h"
#include "loosefit/geometry/principal_axes.h"

namespace loosefit::render {
namespace {

constexpr double kClearance = 0.003;  // [m]
constexpr int kHalvings = 4;          // of the icosahedron's edges: 2562 directions
constexpr int kRoundsAtCloth = 12;
constexpr double kFar = std::numeric_limits<double>::infinity();

geometry::TriangleMesh icosahedron() {
  const double g = (1 + std::sqrt(5.0)) / 2;
  geometry::TriangleMesh mesh;
  for (const auto& [x, y, z] : {std::array{-1.0, g, 0.0},
                                {1.0, g, 0.0},
                                {-1.0, -g, 0.0},
                                {1.0, -g, 0.0},
                                {0.0, -1.0, g},
                                {0.0, 1.0, g},
                                {0.0, -1.0, -g},
                                {0.0, 1.0, -g},
                                {g, 0.0, -1.0},
                                {g, 0.0, 1.0},
                                {-g, 0.0, -1.0},
                                {-g, 0.0, 1.0}})
    mesh.vertices.push_back(Vec3(x, y, z).normalized());
  mesh.triangles = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                    {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                    {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                    {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
  return mesh;
}

/// Unit directions all round, evenly.
geometry::TriangleMesh directions() {
  geometry::TriangleMesh mesh = icosahedron();
  for (int time = 0; time < kHalvings; ++time) {
    std::map<std::pair<int, int>, int> middle;
    const auto between = [&](int a, int b) {
      const auto [place, is_new] = middle.try_emplace(std::minmax(a, b), -1);
      if (is_new) {
        place->second = static_cast<int>(mesh.vertices.size());
        mesh.vertices.push_back((mesh.vertices[a] + mesh.vertices[b]).normalized());
      }
      return place->second;
    };
    std::vector<Triangle> finer;
    for (const Triangle& t : mesh.triangles) {
      const int a = between(t[0], t[1]), b = between(t[1], t[2]), c = between(t[2], t[0]);
      finer.insert(finer.end(), {{t[0], a, c}, {t[1], b, a}, {t[2], c, b}, {a, b, c}});
    }
    mesh.triangles = std::move(finer);
  }
  return mesh;
}

/// Where the ray meets a triangle, as a multiple of it (Möller and Trumbore 1997).
std::optional<double> hit(const Vec3& from, const Vec3& ray, const std::array<Vec3, 3>& t) {
  const Vec3 ab = t[1] - t[0], ac = t[2] - t[0], p = ray.cross(ac);
  const double det = ab.dot(p);
  if (det == 0) return {};
  const Vec3 s = from - t[0], q = s.cross(ab);
  const double u = s.dot(p) / det, v = ray.dot(q) / det, along = ac.dot(q) / det;
  if (u < 0 || v < 0 || u + v > 1 || along <= 0) return {};
  return along;
}

void average(std::vector<double>& radius, const std::vector<std::vector<int>>& neighbours) {
  const std::vector<double> before = radius;
  for (std::size_t i = 0; i < radius.size(); ++i) {
    double sum = 0;
    for (const int j : neighbours[i]) sum += before[j];
    radius[i] = 0.5 * before[i] + 0.5 * sum / static_cast<double>(neighbours[i].size());
  }
}

}  // namespace

geometry::TriangleMesh smooth_solid(const std::vector<Vec3>& points,
                                    const geometry::TriangleMesh& cloth, int rounds) {
  const geometry::TriangleMesh hull =
      points.size() < 4 ? geometry::TriangleMesh{} : geometry::convex_hull(points);
  if (hull.triangles.empty()) return {};
  // Lengths along the principal axes are made alike, for long ones have few directions at the tips.
  Vec3 mean = Vec3::Zero();
  for (const Vec3& p : hull.vertices) mean += p;
  mean /= static_cast<double>(hull.vertices.size());
  Mat3 spread = Mat3::Zero();
  for (const Vec3& p : hull.vertices) spread += (p - mean) * (p - mean).transpose();
  const Mat3 axes = geometry::principal_axes(spread).axes;
  Vec3 low = Vec3::Constant(kFar), high = -low;
  for (const Vec3& p : hull.vertices) {
    low = low.cwiseMin(axes.transpose() * p);
    high = high.cwiseMax(axes.transpose() * p);
  }
  const Vec3 centre = axes * (0.5 * (low + high));
  const Mat3 stretch = axes * (0.5 * (high - low)).asDiagonal();

  geometry::TriangleMesh solid = directions();
  if (stretch.determinant() < 0)
    for (Triangle& t : solid.triangles) std::swap(t[1], t[2]);
  std::vector<Vec3> rays;
  for (const Vec3& u : solid.vertices) rays.push_back(stretch * u);
  std::vector<double> radius(rays.size(), kFar), limit(rays.size(), kFar);
  for (const Triangle& t : hull.triangles) {
    const Vec3 a = hull.vertices[t[0]];
    const Vec3 n = geometry::triangle_normal(a, hull.vertices[t[1]], hull.vertices[t[2]]);
    const double offset = n.dot(a - centre);
    for (std::size_t i = 0; i < rays.size(); ++i)
      if (const double rise = n.dot(rays[i]); rise > 0)
        radius[i] = std::min(radius[i], offset / rise);
  }
  const std::vector<std::vector<int>> neighbours =
      geometry::MeshTopology(solid.triangles).vertex_neighbours();
  for (int round = 0; round < rounds; ++round) average(radius, neighbours);

  // Cloth that is in the way.
  const double reach = 1.1 * 0.5 * (high - low).norm();
  for (const Triangle& t : cloth.triangles) {
    const std::array<Vec3, 3> corners = {cloth.vertices[t[0]], cloth.vertices[t[1]],
                                         cloth.vertices[t[2]]};
    const double size =
        std::max((corners[1] - corners[0]).norm(), (corners[2] - corners[0]).norm());
    if ((corners[0] - centre).norm() > reach + size) continue;
    for (std::size_t i = 0; i < rays.size(); ++i)
      if (const auto along = hit(centre, rays[i], corners))
        limit[i] = std::min(limit[i], *along - kClearance / rays[i].norm());
  }
  for (int round = 0; round <= kRoundsAtCloth; ++round) {
    bool cut = false;
    for (std::size_t i = 0; i < radius.size(); ++i)
      if (limit[i] < radius[i]) {
        radius[i] = std::max(0.05, limit[i]);
        cut = true;
      }
    if (!cut) break;
    if (round < kRoundsAtCloth) average(radius, neighbours);
  }
  for (std::size_t i = 0; i < rays.size(); ++i) solid.vertices[i] = centre + radius[i] * rays[i];
  return solid;
}

}  // namespace loosefit::render

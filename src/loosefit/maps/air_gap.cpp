#include "loosefit/maps/air_gap.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "loosefit/base/error.h"
#include "loosefit/geometry/mesh_topology.h"

namespace loosefit::maps {
namespace {

constexpr double kFarthest = 0.15;  ///< cloth farther off covers nothing [m]

double triple(const Vec3& a, const Vec3& b, const Vec3& c) { return a.dot(b.cross(c)); }

/// Six times the volume between the triangle q on the skin and p over it; the sides, which need not
/// be plane, are the mean of their two halvings.
double prism(const std::array<Vec3, 3>& q, const std::array<Vec3, 3>& p) {
  double sum = triple(p[0], p[1], p[2]) - triple(q[0], q[1], q[2]);
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    sum += 0.5 * (triple(q[i], q[j], p[j]) + triple(q[i], p[j], p[i]) + triple(q[i], q[j], p[i]) +
                  triple(q[j], p[j], p[i]));
  }
  return sum;
}

/// Share of a tetrahedron's volume that lies below a height, from the heights of its corners.
double share_below(std::array<double, 4> z, double height) {
  std::sort(z.begin(), z.end());
  if (height <= z[0]) return 0;
  if (height >= z[3]) return 1;
  const auto part = [&](int i, int j) { return (height - z[i]) / (z[j] - z[i]); };
  if (height <= z[1]) return part(0, 1) * part(0, 2) * part(0, 3);
  if (height >= z[2]) return 1 - (1 - part(0, 3)) * (1 - part(1, 3)) * (1 - part(2, 3));
  // Two corners below: a wedge, cut into three.
  const double a = part(0, 2), b = part(0, 3), c = part(1, 2), d = part(1, 3);
  return a * b * (1 - d) + a * (1 - c) * d + c * d;
}

/// Edges and vertices at the border of a cloth.
struct Border {
  geometry::MeshTopology topology;
  std::vector<char> vertex;

  explicit Border(const garment::Garment& garment)
      : topology(garment.triangles), vertex(garment.vertex_count, 0) {
    for (int e = 0; e < topology.edge_count(); ++e)
      if (topology.sides(e).size() == 1)
        for (int v : topology.edges()[e]) vertex[v] = 1;
  }
  bool holds(const garment::Garment& garment, const geometry::ClosestPoint& point) const {
    constexpr double kNone = 1e-12;
    for (int k = 0; k < 3; ++k) {
      if (point.barycentric[k] > 1 - kNone) return vertex[garment.triangles[point.triangle][k]];
      const int edge = topology.edge(point.triangle, (k + 1) % 3);  // opposite of corner k
      if (point.barycentric[k] < kNone && topology.sides(edge).size() == 1) return true;
    }
    return false;
  }
};

/// A triangle of the inner face of a cloth and the triangle of its partners on the skin.
struct Column {
  std::array<Vec3, 3> skin, inner;
};

Column column(const garment::Garment& garment, const std::vector<Vec3>& positions,
              const WornGarment& worn, double half_thickness, int t, const Vec3& origin) {
  Column column;
  for (int k = 0; k < 3; ++k) {
    const int v = garment.triangles[t][k];
    const Vec3& skin = worn.partners[v].exact.point;
    const Vec3 out = positions[v] - skin;
    const double distance = out.norm();
    const double share = distance > half_thickness ? 1 - half_thickness / distance : 0;
    column.skin[k] = skin - origin;
    column.inner[k] = column.skin[k] + share * out;
  }
  return column;
}

void check_sizes(const std::vector<Vec3>& positions, const WornGarment& worn) {
  if (positions.size() != worn.partners.size())
    throw InvalidInput("air gap: positions and partners differ in number");
}

}  // namespace

AirGap air_gap(const garment::Garment& garment, const std::vector<Vec3>& positions,
               const WornGarment& worn, double half_thickness,
               const std::function<bool(int)>& counts) {
  check_sizes(positions, worn);
  AirGap air;
  for (int t = 0; t < static_cast<int>(garment.triangles.size()); ++t) {
    if (counts && !counts(t)) continue;
    const Vec3 origin = positions[garment.triangles[t][0]];  // near by, for the digits
    const auto& [skin, inner] = column(garment, positions, worn, half_thickness, t, origin);
    Vec3 normal = Vec3::Zero();
    for (int v : garment.triangles[t]) normal += worn.partners[v].normal;
    air.volume += prism(skin, inner) / 6;
    air.skin_area += 0.5 * (skin[1] - skin[0]).cross(skin[2] - skin[0]).dot(normal.normalized());
  }
  return air;
}

double air_between(const garment::Garment& garment, const std::vector<Vec3>& positions,
                   const WornGarment& worn, double half_thickness, double low, double high,
                   const std::function<bool(int)>& counts) {
  check_sizes(positions, worn);
  double volume = 0;
  for (int t = 0; t < static_cast<int>(garment.triangles.size()); ++t) {
    if (counts && !counts(t)) continue;
    const Vec3 origin = positions[garment.triangles[t][0]];
    const auto& [skin, inner] = column(garment, positions, worn, half_thickness, t, origin);
    // In the order of their numbers the corners of a side are halved alike from both of its sides.
    std::array<int, 3> order = {0, 1, 2};
    std::sort(order.begin(), order.end(),
              [&](int a, int b) { return garment.triangles[t][a] < garment.triangles[t][b]; });
    const double turn = (order[1] - order[0] + 3) % 3 == 1 ? 1 : -1;
    const auto& [a, b, c] = order;
    for (const std::array<Vec3, 4>& corner :
         {std::array<Vec3, 4>{skin[a], skin[b], skin[c], inner[c]},
          std::array<Vec3, 4>{skin[a], skin[b], inner[c], inner[b]},
          std::array<Vec3, 4>{skin[a], inner[a], inner[b], inner[c]}}) {
      std::array<double, 4> z;
      for (int k = 0; k < 4; ++k) z[k] = corner[k].z() + origin.z();
      volume += turn / 6 *
                triple(corner[1] - corner[0], corner[2] - corner[0], corner[3] - corner[0]) *
                (share_below(z, high) - share_below(z, low));
    }
  }
  return volume;
}

std::vector<double> skin_gaps(const body::Body& body, const garment::Garment& garment,
                              const std::vector<Vec3>& positions, double half_thickness) {
  const geometry::TriangleMesh cloth{positions, garment.triangles};
  const geometry::ClosestPointTree tree(cloth);
  const Border border(garment);
  std::vector<double> gaps(body.surface.vertices.size(), std::numeric_limits<double>::quiet_NaN());
  for (std::size_t v = 0; v < gaps.size(); ++v) {
    const Vec3& skin = body.surface.vertices[v];
    const geometry::ClosestPoint over = tree.query(skin, kFarthest);
    if (over.triangle < 0 || border.holds(garment, over)) continue;
    if ((over.point - skin).dot(body.normals[v]) < -2 * half_thickness) continue;
    gaps[v] = std::max(0.0, over.distance - half_thickness);
  }
  return gaps;
}

double contact_share(const body::Body& body, const std::vector<double>& gaps, double g0,
                     const std::function<bool(int)>& counts) {
  double covered = 0, touching = 0;
  for (const Triangle& t : body.surface.triangles) {
    const auto& x = body.surface.vertices;
    const double third = geometry::triangle_area(x[t[0]], x[t[1]], x[t[2]]) / 3;
    for (int v : t) {
      if (std::isnan(gaps[v]) || (counts && !counts(v))) continue;
      covered += third;
      if (gaps[v] < g0) touching += third;
    }
  }
  return covered > 0 ? touching / covered : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace loosefit::maps

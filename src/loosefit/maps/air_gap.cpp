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

}  // namespace

AirGap air_gap(const garment::Garment& garment, const std::vector<Vec3>& positions,
               const WornGarment& worn, double half_thickness,
               const std::function<bool(int)>& counts) {
  if (positions.size() != worn.partners.size())
    throw InvalidInput("air gap: positions and partners differ in number");
  AirGap air;
  for (int t = 0; t < static_cast<int>(garment.triangles.size()); ++t) {
    if (counts && !counts(t)) continue;
    const Vec3 origin = positions[garment.triangles[t][0]];  // near by, for the digits
    std::array<Vec3, 3> skin, inner;
    Vec3 normal = Vec3::Zero();
    for (int k = 0; k < 3; ++k) {
      const int v = garment.triangles[t][k];
      const body::BodyPartner& partner = worn.partners[v];
      const Vec3 out = positions[v] - partner.exact.point;
      const double distance = out.norm();
      const double share = distance > half_thickness ? 1 - half_thickness / distance : 0;
      skin[k] = partner.exact.point - origin;
      inner[k] = skin[k] + share * out;
      normal += partner.normal;
    }
    air.volume += prism(skin, inner) / 6;
    air.skin_area += 0.5 * (skin[1] - skin[0]).cross(skin[2] - skin[0]).dot(normal.normalized());
  }
  return air;
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

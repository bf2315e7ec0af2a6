#include "loosefit/maps/pressure.h"

#include <tbb/parallel_for.h>

#include <Eigen/Dense>
#include <Eigen/Geometry>
#include <cmath>
#include <limits>

#include "loosefit/base/error.h"
#include "loosefit/geometry/flat_triangle.h"
#include "loosefit/geometry/mesh_topology.h"
#include "loosefit/geometry/rotation_between.h"
#include "loosefit/maps/cloth_strain.h"
#include "loosefit/maps/surface_curvature.h"

namespace loosefit::maps {
namespace {

/// Body under the middle of a garment edge.
struct Middle {
  double distance = std::numeric_limits<double>::infinity();  ///< to the skin [m]
  Vec3 normal = Vec3::Zero();
  Mat3 curvature = Mat3::Zero();  ///< of the skin [1/m]
};

/// Per edge of the garment.
std::vector<Middle> middles_near_body(const geometry::MeshTopology& topology,
                                      const std::vector<Vec3>& x, const body::PosedBody& body,
                                      double reach) {
  const auto& edges = topology.edges();
  const geometry::ClosestPointTree& tree = body.tree();
  std::vector<geometry::ClosestPoint> under(edges.size());
  tbb::parallel_for(std::size_t{0}, edges.size(), [&](std::size_t i) {
    const auto& [a, b] = edges[i];
    under[i] = tree.query(0.5 * (x[a] + x[b]), reach);
  });
  std::vector<char> wanted(body->surface.vertices.size(), 0);
  for (const geometry::ClosestPoint& hit : under)
    if (hit.triangle >= 0)
      for (int v : body->surface.triangles[hit.triangle]) wanted[v] = 1;
  const std::vector<Mat3> curvatures = vertex_curvatures(body->surface, wanted);
  std::vector<Middle> middles(edges.size());
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const geometry::ClosestPoint& hit = under[i];
    if (hit.triangle < 0) continue;
    Middle& middle = middles[i];
    middle.distance = hit.distance;
    const Triangle& corner = body->surface.triangles[hit.triangle];
    for (int c = 0; c < 3; ++c) middle.normal += hit.barycentric[c] * body->normals[corner[c]];
    middle.normal.normalize();
    middle.curvature = curvature_at(body->surface, curvatures, hit, middle.normal);
  }
  return middles;
}

void check(const garment::Garment& garment, const drape::Drape& drape, const body::Body& body) {
  const auto n = static_cast<std::size_t>(garment.vertex_count);
  if (drape.body_normal_force.empty())
    throw InvalidInput("pressure: the drape does not know the forces of its contact",
                       "it was made by an earlier version; make it again");
  if (drape.positions.size() != n || drape.body_normal_force.size() != n)
    throw InvalidInput("pressure: " + std::to_string(drape.positions.size()) + " positions and " +
                       std::to_string(drape.body_normal_force.size()) + " forces for " +
                       std::to_string(n) + " garment vertices");
  if (body.normals.size() != body.surface.vertices.size())
    throw InvalidInput("pressure needs a body with a normal for every vertex");
}

}  // namespace

double contact_tolerance(const fabric::Material& material) {
  return std::max(0.75 * material.thickness, 0.0005);
}

std::vector<Mat3> membrane_tension(const garment::Garment& garment, const std::vector<Vec3>& x,
                                   const fabric::Material& material) {
  const auto states = membrane_states(garment, x, material);
  std::vector<Mat3> tension;
  for (std::size_t t = 0; t < garment.triangles.size(); ++t) {
    const geometry::DeformationGradient f =
        geometry::deformation_gradient(garment.triangle_uv[t], garment.triangles[t], x);
    const Vec3 s = states[t].stress;
    Mat2 stress;
    stress << s[0], s[2], s[2], s[1];
    const double stretch = f.col(0).cross(f.col(1)).norm();
    tension.push_back(stretch > 0 ? Mat3(f * stress * f.transpose() / stretch)
                                  : Mat3(Mat3::Zero()));
  }
  return tension;
}

PressureField contact_pressure(const garment::Garment& garment, const drape::Drape& drape,
                               const body::PosedBody& body, const fabric::Material& material,
                               double gravity) {
  check(garment, drape, body);
  const std::vector<Vec3>& x = drape.positions;
  const std::size_t n = x.size();
  PressureField field;
  field.contact.assign(n, 0.0);
  field.membrane.assign(n, 0.0);
  field.area.assign(n, 0.0);
  field.touching.assign(n, 0);

  std::vector<double> worn_area;
  for (const Triangle& t : garment.triangles) {
    worn_area.push_back(geometry::triangle_area(x[t[0]], x[t[1]], x[t[2]]));
    for (int v : t) field.area[v] += worn_area.back() / 3;
  }
  for (std::size_t i = 0; i < n; ++i)
    if (drape.body_normal_force[i] > 0 && field.area[i] > 0) {
      field.contact[i] = drape.body_normal_force[i] / field.area[i];
      field.touching[i] = 1;
    }

  const auto weight = [&](int v) {
    return garment.vertex_mass.empty() || !(field.area[v] > 0)
               ? 0.0
               : garment.vertex_mass[v] * gravity / field.area[v];
  };
  constexpr double kHeldOff = 0.01;  // pressed triangles held off beyond this are none [m]
  const geometry::MeshTopology topology(garment.triangles);
  const std::vector<Middle> middles = middles_near_body(topology, x, body, kHeldOff);
  const std::vector<Mat3> tension = membrane_tension(garment, x, material);
  const double touch = 0.5 * material.thickness + contact_tolerance(material);
  for (std::size_t t = 0; t < garment.triangles.size(); ++t) {
    const Triangle& corner = garment.triangles[t];
    std::array<const Middle*, 3> middle{};
    double nearest = std::numeric_limits<double>::infinity();
    bool pressed = true;
    for (int k = 0; k < 3; ++k) {
      middle[k] = &middles[topology.edge(static_cast<int>(t), k)];
      nearest = std::min(nearest, middle[k]->distance);
      pressed = pressed && drape.body_normal_force[corner[k]] > 0;
    }
    if (!(nearest <= (pressed ? kHeldOff : touch))) continue;
    const Vec3 normal = geometry::triangle_normal(x[corner[0]], x[corner[1]], x[corner[2]]);
    for (int k = 0; k < 3; ++k) {
      const int a = corner[k], b = corner[(k + 1) % 3];
      field.touching[a] = 1;
      if (!(middle[k]->distance <= kHeldOff)) continue;
      // The flat triangle leans against the curved contact surface: lay its tension down on it.
      // On a convex body a flat triangle touches in its middle and stands off at its rim; the
      // smooth cloth it stands for lies everywhere as near as that.
      const Vec3 out = normal.dot(middle[k]->normal) < 0 ? Vec3(-normal) : normal;
      const Mat3 turn = geometry::rotation_between(out, middle[k]->normal).toRotationMatrix();
      const Mat3 curvature = offset_curvature(middle[k]->curvature, nearest);
      const double pressure = (turn * tension[t] * turn.transpose()).cwiseProduct(curvature).sum() +
                              0.5 * (weight(a) + weight(b)) * middle[k]->normal.z();
      for (int v : {a, b}) field.membrane[v] += pressure * worn_area[t] / 6;
    }
  }
  for (std::size_t i = 0; i < n; ++i)
    field.membrane[i] = field.area[i] > 0 ? std::max(0.0, field.membrane[i] / field.area[i]) : 0;
  return field;
}

std::vector<double> pressure_class_shares(const PressureField& field) {
  std::vector<double> share(std::size(kPressureClassNames), 0.0);
  double total = 0;
  for (std::size_t i = 0; i < field.contact.size(); ++i) {
    std::size_t k = field.contact[i] > 0 ? 1 : 0;
    if (k == 1)
      for (double bound : kPressureClasses) k += field.contact[i] >= bound;
    share[k] += field.area[i];
    total += field.area[i];
  }
  if (total > 0)
    for (double& s : share) s /= total;
  return share;
}

PressureAgreement compare_pressures(const PressureField& field,
                                    const std::vector<body::Region>& regions,
                                    std::optional<body::Region> only) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  PressureAgreement a;
  double squares = 0;
  const auto each = [&](const auto& visit) {
    for (std::size_t i = 0; i < field.contact.size(); ++i)
      if (field.touching[i] && field.area[i] > 0 && (!only || regions[i] == *only))
        visit(field.contact[i], field.membrane[i], field.area[i]);
  };
  each([&](double contact, double membrane, double area) {
    a.contact_area += area;
    a.contact_force += area * contact;
    a.membrane_force += area * membrane;
    squares += area * (membrane - contact) * (membrane - contact);
  });
  a.contact_mean = a.membrane_mean = a.rms_difference = a.correlation = kNan;
  if (!(a.contact_area > 0)) return a;
  a.contact_mean = a.contact_force / a.contact_area;
  a.membrane_mean = a.membrane_force / a.contact_area;
  a.rms_difference = std::sqrt(squares / a.contact_area);
  double cc = 0, mm = 0, cm = 0;
  each([&](double contact, double membrane, double area) {
    const double c = contact - a.contact_mean, m = membrane - a.membrane_mean;
    cc += area * c * c;
    mm += area * m * m;
    cm += area * c * m;
  });
  // Scatter below rounding is none.
  const double least = 1e-20 * a.contact_area;
  if (cc > least * a.contact_mean * a.contact_mean &&
      mm > least * a.membrane_mean * a.membrane_mean)
    a.correlation = cm / std::sqrt(cc * mm);
  return a;
}

}  // namespace loosefit::maps

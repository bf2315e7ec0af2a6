#pragma once
#include <map>
#include <memory>

#include "loosefit/contact/body_contact.h"
#include "loosefit/contact/distance_field.h"
#include "loosefit/fabric/bending_energy.h"
#include "loosefit/fabric/membrane_energy.h"
#include "loosefit/geometry/closest_point_tree.h"
#include "loosefit/particles/gravity_energy.h"
#include "loosefit/solver/integrator.h"
#include "support/flat_garment.h"

namespace loosefit::support {

/// A piece of cloth on a rigid body, from the energies themselves, so that a test chooses every
/// constant: mesh with pattern coordinates, areas, masses, and the particle system.
struct ClothScene {
  std::vector<Triangle> triangles;
  std::vector<std::array<Vec2, 3>> uv;
  std::vector<double> area;
  particles::VectorField x;
  geometry::TriangleMesh skin;
  std::unique_ptr<geometry::ClosestPointTree> tree;
  std::shared_ptr<const contact::DistanceField> field;
  std::unique_ptr<fabric::MembraneEnergy> membrane;
  std::unique_ptr<fabric::BendingEnergy> bending;
  std::unique_ptr<particles::GravityEnergy> gravity;
  std::unique_ptr<contact::BodyContact> contact;
  solver::ParticleSystem system;

  struct Contact {
    double stiffness = 1e6;     ///< [Pa/m]
    double offset = 2.5e-4;     ///< [m]
    double friction = 0;        ///< Coulomb [–]
    double stick_reach = 1e-4;  ///< [m]
    double spacing = 0.005;     ///< of the distance field [m]
  };

  /// `start` are the first positions of the particles of the sheet `mesh`, whose own positions are
  /// the pattern (u = x, v = y); `same` maps particles that are sewn to others.
  ClothScene(const geometry::TriangleMesh& mesh, const std::map<int, int>& same,
             const particles::VectorField& start, geometry::TriangleMesh body,
             const fabric::Material& m, const Contact& c, double g = kGravity, bool viscous = false)
      : triangles(mesh.triangles), uv(flat_uv(mesh)), x(start), skin(std::move(body)) {
    for (Triangle& t : triangles)
      for (int& v : t)
        if (same.count(v)) v = same.at(v);
    const int n = static_cast<int>(x.size());
    system.mass.assign(n, 0.0);
    geometry::Box3 box;
    for (const Vec3& p : x) box.extend(p);
    const Vec3 margin = Vec3::Constant(0.03);
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      const auto& [p, q, r] = mesh.triangles[t];
      area.push_back(geometry::triangle_area(mesh.vertices[p], mesh.vertices[q], mesh.vertices[r]));
      for (int v : triangles[t]) system.mass[v] += m.areal_density * area.back() / 3;
    }
    tree = std::make_unique<geometry::ClosestPointTree>(skin);
    field = std::make_shared<contact::DistanceField>(
        *tree, geometry::Box3(box.min() - margin, box.max() + margin), c.spacing);
    membrane =
        std::make_unique<fabric::MembraneEnergy>(triangles, uv, std::vector<double>{}, m, viscous);
    bending =
        std::make_unique<fabric::BendingEnergy>(triangles, uv, std::vector<double>{}, m, viscous);
    gravity = std::make_unique<particles::GravityEnergy>(system.mass, g);
    contact = std::make_unique<contact::BodyContact>(
        contact::contact_points(triangles, area, n, c.offset), c.stiffness, c.friction,
        c.stick_reach);
    contact->set_field(field);
    system.energies = {membrane.get(), bending.get(), gravity.get(), contact.get()};
    system.held.assign(n, 0);
    system.gravity = g;
  }
};

/// A sheet whose sides x = 0 and x = width are sewn: which vertices become one, and the others
/// renumbered without holes.
struct RolledSheet {
  geometry::TriangleMesh mesh;  ///< flat; positions are the pattern
  std::map<int, int> same;      ///< mesh vertex → particle
  std::vector<Vec2> place;      ///< pattern position of each particle
};
inline RolledSheet rolled_sheet(double width, double height, double edge, double jitter) {
  RolledSheet r;
  r.mesh = sheet(width, height, edge, jitter);
  std::map<long, int> first_of_row;  // by height in nanometres
  const auto row = [](const Vec3& p) { return std::lround(1e9 * p[1]); };
  for (std::size_t i = 0; i < r.mesh.vertices.size(); ++i) {
    const Vec3& p = r.mesh.vertices[i];
    const bool last = p[0] > width - 1e-9;
    if (last) {
      r.same[static_cast<int>(i)] = first_of_row.at(row(p));
      continue;
    }
    const int particle = static_cast<int>(r.place.size());
    if (p[0] < 1e-9) first_of_row[row(p)] = particle;
    r.same[static_cast<int>(i)] = particle;
    r.place.push_back(p.head<2>());
  }
  return r;
}

/// Positions turned by 90° about the x axis: (x, y, z) → (x, −z, y); what stood lies.
inline geometry::TriangleMesh laid_down(geometry::TriangleMesh mesh) {
  for (Vec3& p : mesh.vertices) p = Vec3(p[0], -p[2], p[1]);
  return mesh;
}

/// Closed, outward oriented box centred at the origin.
inline geometry::TriangleMesh box_mesh(const Vec3& half) {
  geometry::TriangleMesh mesh;
  for (int i = 0; i < 8; ++i)
    mesh.vertices.emplace_back((i & 1 ? 1 : -1) * half[0], (i & 2 ? 1 : -1) * half[1],
                               (i & 4 ? 1 : -1) * half[2]);
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

}  // namespace loosefit::support

#include "loosefit/validate/specimen.h"

#include <fmt/format.h>

#include <cmath>

#include "loosefit/base/error.h"
#include "loosefit/contact/distance_field.h"
#include "loosefit/garment/assemble.h"
#include "loosefit/solver/quasi_static.h"

namespace loosefit::validate {

Specimen cut_specimen(const std::vector<Vec2>& outline, double edge_length,
                      const fabric::Material& material,
                      const std::vector<std::array<int, 2>>& sewn) {
  pattern::Pattern pattern;
  pattern.name = "specimen";
  pattern::Panel panel;
  panel.name = "specimen";
  panel.vertices = outline;
  const int sides = static_cast<int>(outline.size());
  for (int i = 0; i < sides; ++i) {
    pattern::PanelEdge edge;
    edge.start = i;
    edge.end = (i + 1) % sides;
    edge.name = fmt::format("side_{}", i);
    panel.edges.push_back(edge);
  }
  pattern.panels.push_back(panel);
  pattern.panel_order = {0};
  for (const auto& [first, second] : sewn) {
    pattern::Stitch stitch;
    stitch.first = {0, first};
    stitch.second = {0, second};
    stitch.name = fmt::format("seam_{}_{}", first, second);
    pattern.stitches.push_back(stitch);
  }
  return garment::assemble(pattern, edge_length, material);
}

Specimen cut_rectangle(double width, double height, double edge_length,
                       const fabric::Material& material, bool closed) {
  std::vector<std::array<int, 2>> sewn;
  if (closed) sewn.push_back({3, 1});
  return cut_specimen({{0, 0}, {width, 0}, {width, height}, {0, height}}, edge_length, material,
                      sewn);
}

void turn_grain(Specimen& specimen, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  Mat2 turn;
  turn << c, s, -s, c;
  for (auto& corners : specimen.triangle_uv)
    for (Vec2& p : corners) p = turn * p;
}

std::vector<int> vertices_where(const Specimen& specimen,
                                const std::function<bool(const Vec2&)>& inside) {
  std::vector<int> selected;
  for (int i = 0; i < specimen.vertex_count; ++i)
    if (inside(specimen.vertex_uv[i])) selected.push_back(i);
  return selected;
}

std::string mesh_text(const Specimen& specimen) {
  double sum = 0;
  for (const auto& c : specimen.triangle_uv)
    for (int k = 0; k < 3; ++k) sum += (c[(k + 1) % 3] - c[k]).norm();
  const double mean = sum / (3.0 * static_cast<double>(specimen.triangles.size()));
  return fmt::format("{:.2g} mm edges, {} triangles", 1e3 * mean, specimen.triangles.size());
}

double PointLoads::value(const particles::VectorField& x) const {
  double energy = 0;
  for (const auto& [i, f] : force) energy -= f.dot(x[i]);
  return energy;
}

void PointLoads::add_gradient(const particles::VectorField& x, particles::VectorField& g) const {
  (void)x;
  for (const auto& [i, f] : force) g[i] -= f;
}

Bench::Bench(Specimen specimen, const fabric::Material& material,
             const std::function<Vec3(const Vec2&)>& place, const Options& options)
    : specimen_(std::move(specimen)), material_(material) {
  for (const Vec2& p : specimen_.vertex_uv) x.push_back(place(p));
  drape::DrapeOptions drape;
  drape.gravity = options.gravity;
  if (options.dynamic) drape.integrator = drape::IntegratorKind::implicit_euler;
  cloth_ = std::make_unique<drape::ClothModel>(specimen_, material_, drape, material_.thickness);
  cloth_->system().held.assign(specimen_.vertex_count, 0);
  cloth_->system().energies.push_back(&loads_);
}

void Bench::touch(geometry::TriangleMesh body, double margin) {
  body_ = std::move(body);
  body_tree_ = std::make_unique<geometry::ClosestPointTree>(body_);
  geometry::Box3 box;
  for (const Vec3& p : x) box.extend(p);
  const Vec3 wide = Vec3::Constant(margin);
  cloth_->body().set_field(std::make_shared<contact::DistanceField>(
      *body_tree_, geometry::Box3(box.min() - wide, box.max() + wide)));
}

void Bench::hold(const std::vector<int>& vertices) {
  for (int v : vertices) cloth_->system().held[v] = 1;
}

Vec3 Bench::reaction(const std::vector<int>& vertices) const {
  particles::VectorField g(x.size(), Vec3::Zero());
  for (const particles::Energy* e : cloth_->system().energies) e->add_gradient(x, g);
  Vec3 sum = Vec3::Zero();
  for (int v : vertices) sum += g[v];
  return sum;
}

solver::SettleOutcome settle_bench(Bench& bench, Progress& progress, double tolerance,
                                   bool must_settle, int max_iterations) {
  solver::SettleOptions options;
  options.tolerance = tolerance;
  options.max_iterations = max_iterations;
  options.watch = [&](int, double) {
    progress.check_cancelled();
    return false;
  };
  const solver::SettleOutcome outcome =
      solver::make_quasi_static(bench.system())->settle(bench.x, options);
  if (must_settle && outcome.reason != solver::SettleOutcome::Reason::converged)
    throw SolverFailure(
        fmt::format("the specimen did not settle: {} at residual {:.2g}, wanted {:.2g}",
                    outcome.text(), outcome.residual, tolerance));
  return outcome;
}

geometry::TriangleMesh rigid_box(const Vec3& half_size) {
  geometry::TriangleMesh mesh;
  for (int i = 0; i < 8; ++i)
    mesh.vertices.emplace_back((i & 1 ? 1 : -1) * half_size[0], (i & 2 ? 1 : -1) * half_size[1],
                               (i & 4 ? 1 : -1) * half_size[2]);
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

geometry::TriangleMesh rigid_cylinder(double radius, double z0, double z1, int rows, int sectors) {
  geometry::TriangleMesh mesh;
  for (int i = 0; i <= rows; ++i)
    for (int j = 0; j < sectors; ++j) {
      const double a = 2 * kPi * j / sectors;
      mesh.vertices.emplace_back(radius * std::cos(a), radius * std::sin(a),
                                 z0 + (z1 - z0) * i / rows);
    }
  const auto id = [&](int i, int j) { return i * sectors + j % sectors; };
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < sectors; ++j) {
      mesh.triangles.push_back({id(i, j), id(i, j + 1), id(i + 1, j + 1)});
      mesh.triangles.push_back({id(i, j), id(i + 1, j + 1), id(i + 1, j)});
    }
  const int bottom = static_cast<int>(mesh.vertices.size()), top = bottom + 1;
  mesh.vertices.emplace_back(0, 0, z0);
  mesh.vertices.emplace_back(0, 0, z1);
  for (int j = 0; j < sectors; ++j) {
    mesh.triangles.push_back({bottom, id(0, j + 1), id(0, j)});
    mesh.triangles.push_back({top, id(rows, j), id(rows, j + 1)});
  }
  return mesh;
}

}  // namespace loosefit::validate

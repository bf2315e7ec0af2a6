#pragma once
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "loosefit/base/progress.h"
#include "loosefit/drape/cloth_model.h"
#include "loosefit/garment/garment.h"
#include "loosefit/geometry/closest_point_tree.h"
#include "loosefit/solver/integrator.h"

namespace loosefit::validate {

/// A piece of cloth cut for a benchmark: meshed, sewn and weighed like a garment of one panel;
/// garment.vertex_uv is the flat position of every vertex [m], u = x weft, v = y warp.
using Specimen = garment::Garment;

/// Polygon outline (counter-clockwise) [m]; straight sides are divided evenly. `sewn` are pairs of
/// sides (side i runs from corner i to i + 1) joined as seams, the end of one to the start of the
/// other. \throws as assemble does.
Specimen cut_specimen(const std::vector<Vec2>& outline, double edge_length,
                      const fabric::Material& material,
                      const std::vector<std::array<int, 2>>& sewn = {});
/// Rectangle [0, width] × [0, height]; `closed` sews the side x = width to x = 0 (a tube).
Specimen cut_rectangle(double width, double height, double edge_length,
                       const fabric::Material& material, bool closed = false);
/// Turns the grain: warp runs at `angle` [rad] from the y axis, towards −x. Positions stay.
void turn_grain(Specimen& specimen, double angle);
/// Vertices whose flat position satisfies the predicate.
std::vector<int> vertices_where(const Specimen& specimen,
                                const std::function<bool(const Vec2&)>& inside);
/// "5 mm edges, 1 240 triangles" (mean edge).
std::string mesh_text(const Specimen& specimen);

/// Dead loads on vertices: Π = −Σ f_i · x_i [J].
class PointLoads : public particles::Energy {
 public:
  std::map<int, Vec3> force;  ///< [N]
  double value(const particles::VectorField& x) const override;
  void add_gradient(const particles::VectorField& x, particles::VectorField& g) const override;
  void add_pattern(const particles::VectorField&, particles::BlockPattern&) const override {}
  void add_hessian(const particles::VectorField&, particles::BlockMatrix&,
                   particles::HessianKind) const override {}
};

/// A specimen under test: the energies of the drape stage (ClothModel, all its constants) at
/// positions x, with optional dead loads, held vertices and a rigid body to touch.
class Bench {
 public:
  struct Options {
    double gravity = kGravity;  ///< [m/s²]
    bool dynamic = false;       ///< with viscosity, for the integrators in time
  };
  /// `place` maps a flat position to the start [m].
  Bench(Specimen specimen, const fabric::Material& material,
        const std::function<Vec3(const Vec2&)>& place)
      : Bench(std::move(specimen), material, place, Options{}) {}
  Bench(Specimen specimen, const fabric::Material& material,
        const std::function<Vec3(const Vec2&)>& place, const Options& options);
  Bench(const Bench&) = delete;
  Bench& operator=(const Bench&) = delete;

  /// A rigid body to lie on, closed and oriented outwards. The contact field (5 mm grid, as in
  /// drapes) covers the cloth's present box widened by `margin` [m].
  void touch(geometry::TriangleMesh body, double margin = 0.03);
  void hold(const std::vector<int>& vertices);
  /// Σ over held `vertices` of the force that holds them there [N].
  Vec3 reaction(const std::vector<int>& vertices) const;
  /// Potential energy at x, all forces included [J].
  double energy() const { return cloth_->system().potential(x); }

  const Specimen& specimen() const { return specimen_; }
  const std::vector<Vec2>& flat() const { return specimen_.vertex_uv; }
  const fabric::Material& material() const { return material_; }
  drape::ClothModel& cloth() { return *cloth_; }
  solver::ParticleSystem& system() { return cloth_->system(); }
  PointLoads& loads() { return loads_; }

  particles::VectorField x;  ///< positions [m]

 private:
  Specimen specimen_;
  fabric::Material material_;
  std::unique_ptr<drape::ClothModel> cloth_;
  PointLoads loads_;
  geometry::TriangleMesh body_;
  std::unique_ptr<geometry::ClosestPointTree> body_tree_;
};

inline constexpr double kBenchTolerance = 1e-6;  ///< residual at which a specimen is at rest

/// The one solver configuration of all benchmarks: the quasi-static integrator with its own options
/// (the full tangent, where drapes take the near one) at a residual of `tolerance` (‖F‖/‖W‖;
/// newtons without weight). Each call is one step of the load history: friction keeps the anchors
/// that earlier calls on this bench left. \throws SolverFailure naming the residual when it does
/// not settle and `must_settle`.
solver::SettleOutcome settle_bench(Bench& bench, Progress& progress,
                                   double tolerance = kBenchTolerance, bool must_settle = true,
                                   int max_iterations = 3000);

/// Closed rigid shapes, outward oriented [m].
geometry::TriangleMesh rigid_box(const Vec3& half_size);
/// Cylinder along z from z0 to z1 with `sectors` flat facets.
geometry::TriangleMesh rigid_cylinder(double radius, double z0, double z1, int rows, int sectors);

}  // namespace loosefit::validate

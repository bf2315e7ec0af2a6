#include "loosefit/validate/contact_specimen.h"

#include <fmt/format.h>

#include <cmath>

#include "loosefit/base/error.h"
#include "loosefit/solver/quasi_static.h"

namespace loosefit::validate {

Grip try_grip(Bench& bench, const std::function<double()>& travel, double slip, double tolerance,
              Progress& progress, int max_iterations) {
  Grip grip;
  solver::SettleOptions options;
  options.tolerance = tolerance;
  options.max_iterations = max_iterations;
  options.watch = [&](int, double) {
    progress.check_cancelled();
    return travel() > slip;
  };
  const solver::SettleOutcome outcome =
      solver::make_quasi_static(bench.system())->settle(bench.x, options);
  grip.travel = travel();
  grip.residual = outcome.residual;
  grip.holds = outcome.reason == solver::SettleOutcome::Reason::converged && grip.travel <= slip;
  if (!grip.holds && grip.travel <= slip)
    throw SolverFailure(
        fmt::format("friction neither held nor slipped: {} after {} iterations, moved {:.3g} mm, "
                    "residual {:.2g}",
                    outcome.text(), outcome.work.iterations, 1e3 * grip.travel, outcome.residual));
  return grip;
}

FrictionLimit least_friction(double low, double high, double width,
                             const std::function<bool(double)>& holds) {
  if (holds(low)) return {low, low};
  if (!holds(high)) return {high, high};
  const double enough = width * low;
  while (high - low > enough) {
    const double middle = 0.5 * (low + high);
    (holds(middle) ? high : low) = middle;
  }
  return {low, high};
}

particles::VectorField body_force(Bench& bench) {
  particles::VectorField force(bench.x.size(), Vec3::Zero());
  bench.cloth().body().add_gradient(bench.x, force);
  for (Vec3& f : force) f = -f;
  return force;
}

Vec3 over_cylinder(double s, double y, double r) {
  if (s < 0) return {-r, y, s};
  if (s > kPi * r) return {r, y, kPi * r - s};
  return {-r * std::cos(s / r), y, r * std::sin(s / r)};
}

geometry::TriangleMesh lying_cylinder(double radius, double y0, double y1) {
  geometry::TriangleMesh mesh = rigid_cylinder(radius, y0, y1, 8, 360);
  for (Vec3& p : mesh.vertices) p = Vec3(p[0], p[2], -p[1]);  // turned about the x axis
  return mesh;
}

}  // namespace loosefit::validate

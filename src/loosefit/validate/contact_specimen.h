#pragma once
#include <functional>
#include <string>

#include "loosefit/validate/specimen.h"

namespace loosefit::validate {

/// What the contact and friction benchmarks share.

/// Does friction hold? A quasi-static run with the options of all benchmarks that ends early when
/// the cloth has slipped.
struct Grip {
  bool holds = false;   ///< came to rest before it had moved by `slip`
  double travel = 0;    ///< how far it had moved at the end [m]
  double residual = 0;  ///< force balance at the end
};
/// `travel` measures the movement [m] at bench.x; slipping is a travel beyond `slip` [m].
Grip try_grip(Bench& bench, const std::function<double()>& travel, double slip, double tolerance,
              Progress& progress, int max_iterations = 2000);

/// Where a bisection has ended.
struct FrictionLimit {
  double slips = 0, holds = 0;  ///< the largest coefficient that slipped, the least that held
  double value() const { return 0.5 * (slips + holds); }
  double resolution() const { return 0.5 * (holds - slips); }  ///< the value is known to ± this
};
/// Least coefficient in [low, high] that holds, by bisection to a width of `width`·low; `holds` is
/// asked for single coefficients. Both ends are `low` when it holds already, `high` when that does
/// not: choose them farther apart than the gate.
FrictionLimit least_friction(double low, double high, double width,
                             const std::function<bool(double)>& holds);

/// Force of the body on the particles: normal contact and friction [N].
particles::VectorField body_force(Bench& bench);

/// Wraps a flat strip along +x round a cylinder about the y axis and lets both ends hang: s < 0
/// rises to the cylinder at x = −r, s in [0, π r] runs over the top, the rest falls at x = +r.
Vec3 over_cylinder(double s, double y, double r);

/// A cylinder of `radius` along the y axis from y0 to y1 [m].
geometry::TriangleMesh lying_cylinder(double radius, double y0, double y1);

}  // namespace loosefit::validate

#pragma once
#include <optional>

#include "loosefit/solver/particle_system.h"

namespace loosefit::solver {

/// Numbers of the stability test.
struct StabilityTuning {
  /// Inertia that is added to the Hessian before it is asked [1/s²]: what nothing resists, such as
  /// a tube that turns on a smooth body, has no curvature but round-off. It lets pass what would
  /// take more than 10 s to grow by a factor e.
  double neutral = 1e-2;
  /// First shift that is tried to hold the unstable modes [1/s²], its growth, and the largest: far
  /// above any curvature of cloth (1e6/s² has a period of 6 ms).
  double first_hold = 1, hold_growth = 10, largest_hold = 1e9;
  /// Halvings, in the logarithm, of the last interval: a shift just above the lowest eigenvalue
  /// makes the inverse iteration quick.
  int halvings = 3;
  /// Inverse iteration ends when the curvature changes by less than this share [–], or after so
  /// many solutions. Any direction of negative curvature serves.
  double accuracy = 0.01;
  int max_iterations = 100;
};

/// A direction in which an equilibrium is a maximum of the energy.
struct UnstableMode {
  particles::VectorField direction;  ///< largest length 1 [–]; zero for held particles
  double curvature = 0;              ///< v·Hv / v·Mv [1/s²], negative: growth rate squared
};

/// Whether the equilibrium at x is stable: the exact Hessian of all energies, held particles left
/// out, is positive definite (a Cholesky factor in double precision exists; StabilityTuning::
/// neutral). Lagged state, such as friction and its anchors, is taken as the last begin_step left
/// it. Leaves the plate tangent set. One factorisation.
bool is_stable(const ParticleSystem& system, const particles::VectorField& x,
               const StabilityTuning& tuning = {});

/// The mode of lowest curvature where the equilibrium at x is not stable, by inverse iteration on
/// the shifted Hessian (Parlett 1998, ch. 4); nothing where it is stable, or where no shift makes
/// it definite. Deterministic.
std::optional<UnstableMode> lowest_unstable_mode(const ParticleSystem& system,
                                                 const particles::VectorField& x,
                                                 const StabilityTuning& tuning = {});

}  // namespace loosefit::solver

#pragma once
#include <optional>

#include "loosefit/solver/newton_step.h"
#include "loosefit/solver/region_problem.h"

namespace loosefit::solver {

/// Nonlinear elimination (Lanzkron, Rose and Wilkes 1996; Cai and Li 2011): after a Newton step on
/// a drape nearly all of the unbalanced force is on a few vertices, the tips of folds, which the
/// step would move along by one triangle at a time. They are moved on by Newton steps of their own,
/// with all others held where they are, until most of their force is gone. Each lowers the energy
/// as any Newton step does, so that the equilibria are the same. Which kinds of matrix are definite
/// on one region is taken as a hint for the next.
class RegionRelaxation {
 public:
  explicit RegionRelaxation(const ParticleSystem& system, const SolverTuning& tuning = {})
      : system_(system),
        tuning_(tuning.region),
        problem_(system, tuning.precision),
        step_(tuning_.matrix, tuning_.search, tuning_.step) {}

  /// Moves the region of `force`, the gradient of potential and inertia at x. `tangent` lends its
  /// pattern and memory, and is left with a matrix of no use; `order`: elimination order of all
  /// particles. max_move: of a particle in a step [m]. Returns the number of steps; nothing if the
  /// force is not on a few particles: then the energies have not been asked.
  std::optional<int> relax(particles::VectorField& x, const particles::VectorField& force,
                           const InertiaTerm& inertia, double max_move,
                           const std::vector<int>& order, TangentMatrix& tangent);

 private:
  int relax_active_set(particles::VectorField& x, const InertiaTerm& inertia);

  const ParticleSystem& system_;
  RegionTuning tuning_;
  RegionProblem problem_;
  NewtonStep step_;
};

}  // namespace loosefit::solver

#pragma once
#include "loosefit/solver/descent_method.h"
#include "loosefit/solver/full_problem.h"
#include "loosefit/solver/region_relaxation.h"

namespace loosefit::solver {

/// Newton's method on all particles (NewtonStep), each step followed by steps of the few particles
/// that bear most of the force that is left (RegionRelaxation). docs/decisions/0008 compares it
/// with other methods. Keeps the pattern of the matrix, and the energy and the gradient at the last
/// place, between calls.
class Newton : public DescentMethod {
 public:
  explicit Newton(const ParticleSystem& system, const SolverTuning& tuning = {})
      : system_(system),
        tuning_(tuning),
        problem_(system, tuning.precision),
        step_(tuning.matrix, tuning.search, tuning.step),
        region_(system, tuning) {}

  void restart(double max_move) override;
  StepOutcome iterate(particles::VectorField& x, const particles::VectorField& target,
                      double dt) override;
  void begin_step(const particles::VectorField& x, double dt) override;
  const particles::VectorField& gradient(const particles::VectorField& x) override;
  const SolverWork& work() const override { return problem_.work(); }

 private:
  void relax_region(particles::VectorField& x, const InertiaTerm& inertia);

  const ParticleSystem& system_;
  SolverTuning tuning_;
  FullProblem problem_;
  NewtonStep step_;
  RegionRelaxation region_;
  Iterate at_;
  bool evaluated_ = false;  ///< `at_` is a place with the present state of the energies
};

}  // namespace loosefit::solver

#pragma once
#include "loosefit/solver/backoff.h"
#include "loosefit/solver/inertia_term.h"
#include "loosefit/solver/linear/newton_system.h"
#include "loosefit/solver/region_relaxation.h"
#include "loosefit/solver/solver_work.h"
#include "loosefit/solver/tangent_matrix.h"

namespace loosefit {

/// Newton's method for one step  min_x Π(x) + Σ m_i/(2 dt²) |x_i − x̂_i|²  with line search, step
/// limit by collision detection, and the exact Hessian while it is definite, a projected one
/// otherwise (docs/decisions/0008 compares it with others). After each step the few particles that
/// bear the force that is left are moved on by themselves (RegionRelaxation). Keeps the pattern of
/// the matrix, and the energy and the gradient at the last place, between calls.
class Newton {
 public:
  struct Options {
    double max_move = 0.02;  ///< largest particle move in one step, of all or of a region [m]
    int max_backtracks = 25;
    /// Particles from which on a region of them is relaxed; below, a step of all costs little more.
    int relax_from = 2000;
  };
  struct Outcome {
    bool moved = false;  ///< false: no descent possible
    double share = 0;    ///< accepted multiple of the Newton step, collisions included
    double force = 0;    ///< ‖∂(Π + inertia)/∂x‖ before the move [N]
    bool exact = false;  ///< its matrix was not projected
  };

  explicit Newton(const ParticleSystem& system) : Newton(system, Options{}) {}
  Newton(const ParticleSystem& system, const Options& options);

  /// Counts work anew; the particles may have been moved and contacts changed.
  void restart(const Options& options);
  /// One iteration. target = x̂, dt [s]; dt = ∞ leaves out the inertia term.
  Outcome iterate(VectorField& x, const VectorField& target, double dt);
  /// Energy::begin_step of all energies.
  void begin_step(const VectorField& x, double dt);
  /// ∂Π/∂x at x, remembered until x or the energies change. \post the next `iterate` at x is
  /// cheaper
  const VectorField& gradient(const VectorField& x);
  const SolverWork& work() const { return work_; }

 private:
  void evaluate(const VectorField& x, double& energy, VectorField& g);
  void assemble(const VectorField& x, HessianKind kind);
  bool factorise(const VectorField& x, double per_dt2);
  void direction(const VectorField& g, VectorField& dx);
  void relax_region(VectorField& x, const InertiaTerm& inertia);

  const ParticleSystem& system_;
  Options options_;
  SolverWork work_;
  NewtonSystem linear_;
  TangentMatrix tangent_;
  RegionRelaxation region_;
  std::vector<double> shift_;  ///< inertia and what makes the matrix definite [kg/s²]
  bool exact_ = false;
  Backoff try_exact_{8}, try_halved_{8};  ///< these matrices
  double hold_ = 100;                     ///< [1/s²], see factorise
  double stretch_;                        ///< how far to look along a projected step
  bool evaluated_ = false;                ///< energy_ and gradient_ are those of place_
  VectorField place_, gradient_;
  double energy_ = 0;
};

}  // namespace loosefit

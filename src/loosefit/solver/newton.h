#pragma once
#include "loosefit/solver/particle_system.h"
#include "loosefit/solver/sparse_cholesky.h"

namespace loosefit {

/// Newton's method for one step  min_x Π(x) + Σ m_i/(2 dt²) |x_i − x̂_i|²  with line search, step
/// limit by collision detection, and the exact Hessian while it is definite, a projected one
/// otherwise. Keeps the matrix and its factor between calls.
class Newton {
 public:
  struct Options {
    double max_move = 0.02;  ///< largest particle move in one iteration [m]
    int max_backtracks = 25;
  };
  struct Counters {
    int iterations = 0, factorisations = 0;
    /// Wall seconds: matrices, their factors, solutions, step limits, energies and forces.
    double assemble = 0, factorise = 0, solve = 0, collide = 0, evaluate = 0;
  };
  struct Outcome {
    bool moved = false;  ///< false: no descent possible
    double share = 0;    ///< accepted multiple of the Newton step, collisions included
    double force = 0;    ///< ‖∂(Π + inertia)/∂x‖ before the move [N]
  };

  explicit Newton(const ParticleSystem& system) : Newton(system, Options{}) {}
  Newton(const ParticleSystem& system, const Options& options);

  /// One iteration. target = x̂, dt [s]; dt = ∞ leaves out the inertia term.
  Outcome iterate(VectorField& x, const VectorField& target, double dt);
  const Counters& counters() const { return counters_; }

 private:
  VectorField gradient(const VectorField& x, const VectorField& target, double per_dt2);
  double objective(const VectorField& x, const VectorField& target, double per_dt2);
  bool solve(const VectorField& x, const VectorField& g, double per_dt2, VectorField& dx);
  const ParticleSystem& system_;
  Options options_;
  Counters counters_;
  SparseCholesky cholesky_;
  BlockMatrix matrix_;
public:
  bool exact_ = false;  ///< the last step used the exact Hessian
  int wait_ = 0;        ///< iterations left in which the exact Hessian is not tried
  int patience_ = 1;
};

}  // namespace loosefit

#pragma once
#include <cstdint>
#include <deque>

#include "loosefit/solver/particle_system.h"
#include "loosefit/solver/sparse_cholesky.h"

namespace loosefit {

/// Newton's method for one step  min_x Π(x) + Σ m_i/(2 dt²) |x_i − x̂_i|²  with line search, step
/// limit by collision detection, and the exact Hessian while it is definite, a projected one
/// otherwise. The factor of one matrix serves several iterations; in between the last changes of
/// the gradient correct it (limited-memory BFGS with the factor as its first matrix; Nocedal 1980;
/// Liu, Bouaziz and Kavan 2017). Keeps the matrix and its factor between calls.
class Newton {
 public:
  struct Options {
    double max_move = 0.02;  ///< largest particle move in one iteration [m]
    int max_backtracks = 25;
    int max_reuse = 0;  ///< iterations after the first that share a factor
    int memory = 0;     ///< corrections kept
    int curved = 0; double probe = 0.1, most_bend = 0.75;
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
    bool fresh = false;  ///< its matrix was that of this place
    double bent = 0;
    bool exact = false;  ///< … and was not projected
  };

  explicit Newton(const ParticleSystem& system) : Newton(system, Options{}) {}
  Newton(const ParticleSystem& system, const Options& options);

  /// One iteration. target = x̂, dt [s]; dt = ∞ leaves out the inertia term.
  Outcome iterate(VectorField& x, const VectorField& target, double dt);
  /// ∂Π/∂x at x, remembered until x or the energies change. \post the next `iterate` at x is cheaper
  const VectorField& gradient(const VectorField& x);
  /// The energies changed (Energy::begin_step): what is remembered of them is void.
  void energies_changed() { evaluated_ = false; }
  /// The next iteration takes a new matrix.
  void forget_factor() { has_factor_ = false; }
  const Counters& counters() const { return counters_; }

 private:
  struct Correction {
    VectorField s, y;  ///< y of Π alone
  };
  void evaluate(const VectorField& x, double& energy, VectorField& g);
  double inertia(const VectorField& x, const VectorField& target, double per_dt2) const;
  void add_inertia(const VectorField& x, const VectorField& target, double per_dt2,
                   VectorField& g) const;
  void assemble(const VectorField& x, HessianKind kind);
  bool refresh(const VectorField& x, double per_dt2);
  void direction(const VectorField& g, double per_dt2, VectorField& dx);
  void remember(const VectorField& dx, double t, const VectorField& g_new);

  const ParticleSystem& system_;
  Options options_;
  Counters counters_;
  SparseCholesky cholesky_;
  BlockMatrix matrix_;
  std::uint64_t pattern_version_ = 0;
  bool has_factor_ = false, exact_ = false;
  double factor_per_dt2_ = 0;
  int reused_ = 0; double bent_ = 0;
  int wait_ = 0;  ///< fresh matrices left for which the exact Hessian is not tried
  int patience_ = 1;
  std::deque<Correction> corrections_;
  bool evaluated_ = false;  ///< energy_ and gradient_ are those of place_
  VectorField place_, gradient_;
  double energy_ = 0;
};

}  // namespace loosefit

#pragma once
#include "loosefit/solver/linear/linear_tuning.h"

namespace loosefit::solver {

// All tuning numbers of the nonlinear solver. They change the way to an equilibrium and its cost,
// never the equilibrium, which the force balance alone defines (docs/theory/solver.md 1). "Swept":
// the figures are in bench/reports/engine.md. A number without a reason was found by trial and has
// not been swept.

/// Which matrix a Newton step takes (matrix_choice.h).
struct MatrixTuning {
  /// Kinds that are tried before the projected matrix.
  bool exact = true, half_compression = true;
  /// Regularised matrices that are tried after the projected one, their first shift [1/s²] and its
  /// growth. Cloth that is free to slide leaves the projected matrix singular; a shift of any size
  /// mends that, so the growth is coarse.
  int max_regularisations = 11;
  double first_regularisation = 1, regularisation_growth = 100;
};

/// Backtracking line search (line_search.h).
struct LineSearchTuning {
  /// Share of the linear decrease that a step must reach [–] (Armijo; 1e-4 is the usual value).
  double armijo = 1e-4;
  /// Halvings of a step before it is given up: 2^-25 of a Newton step is below round-off.
  int max_backtracks = 25;
  /// An expected decrease below so large a share of the energy (plus the floor [J]) is below
  /// round-off; then a smaller force decides. About 500 units in the last place, sums over
  /// thousands of elements carry no more digits.
  double round_off = 1e-13, round_off_floor = 1e-12;
  /// Whether that rule applies; where it does not, such a step fails.
  bool accept_below_round_off = true;
  /// A step is doubled only if the slope at its end is still below 1/3 of the slope at its start:
  /// a parabola through both slopes then has its minimum beyond 1.5 steps.
  double extension_slope_divisor = 3;
};

/// Length of a Newton step (NewtonStep).
struct StepTuning {
  /// Largest move of a particle in one step [m], of all or of a region: a trust region in the
  /// maximum norm.
  double max_move = 0.02;
  /// How far to look along a step whose matrix was not exact, in Newton steps: at first, and at
  /// most after a longer one was taken whole. Projected matrices are too stiff along buckling
  /// directions (swept: eight at once wasted evaluations).
  double first_extension = 2, max_extension = 8;
  /// Share of the extended step from which it counts as taken whole.
  double whole = 0.9;
  /// An extension that was taken whole grows so many times.
  double extension_growth = 2;
};

/// Relaxation of the few particles that bear most of the force (RegionRelaxation). Seeds, rings,
/// extent and steps are swept.
struct RegionTuning {
  int min_particles = 2000;   ///< of the cloth; below, a step of all particles costs little more
  double force_share = 0.95;  ///< of ‖force‖² that the seeds bear
  double max_seeds = 0.02;    ///< as a share of all particles; more: the force is spread out
  int rings = 4;              ///< round the seeds, steps on the graph of the matrix (of two edges)
  double max_extent = 0.15;   ///< most particles in the region, as a share of all
  int max_steps = 5;          ///< Newton steps on one region
  /// Share of the region's force at which it is good enough: the border is held, which makes more
  /// of it pointless.
  double relaxed = 0.1;
  MatrixTuning matrix{.max_regularisations = 0};
  /// A region that needs more halvings is left to the next step of all particles.
  LineSearchTuning search{.max_backtracks = 8, .accept_below_round_off = false};
  /// max_move is that of the step of all particles.
  StepTuning step{.max_extension = 2};
};

/// Pseudo-transient continuation (QuasiStatic).
struct QuasiStaticTuning {
  /// Newton steps before friction and contacts are renewed: few while these are far from what they
  /// will be; doubled up to the maximum after each `no_progress` iterations without `progress`, for
  /// then friction is what the cloth chases.
  int newton_per_step = 3, max_newton_per_step = 12;
  int no_progress = 20;
  /// Factor below which the residual must fall to count as progress [–].
  double progress = 0.7;
  /// Fall of the force at which the steps on one pseudo-step end early [–].
  double step_reduction = 0.1;
  /// Pseudo-time step [s]: its bounds, and the length from which inertia is left out, so that steps
  /// are plain Newton on the static balance. 1e3 s: the term is then below 1e-6/s² times mass, far
  /// below any stiffness of cloth.
  double min_dt = 1e-4, inertialess_dt = 1e3, max_dt = 1e4;
  /// Growth of dt after steps of which `whole` was taken, and of which `most` was.
  double growth = 4, slow_growth = 1.5;
  double whole = 0.9, most = 0.4;
  /// Below the share `cut_back` dt shrinks, and once more where no step was found.
  double cut_back = 0.1, shrink = 0.4, stall_shrink = 0.1;
  /// A cycle: so many static iterations without `progress`. Cloth then snaps to and fro between two
  /// shapes: damped steps follow, from damped_dt [s], which grow more slowly each time (square root
  /// of the growth, not below min_growth).
  int cycle = 60;
  double damped_dt = 0.1, min_growth = 1.2;
  /// Rounds in a row without a step after which the plate tangent takes over from the hinge
  /// tangent, which may be too far from the exact one; and after which the cloth is stuck.
  int stalls_to_plate = 4, max_stalls = 8;
};

/// Backward Euler with a fixed time step.
struct ImplicitEulerTuning {
  int newton_per_step = 8;       ///< Newton steps on one time step, at most
  double step_reduction = 0.02;  ///< fall of the force at which they end early [–]
};

/// The paper's explicit scheme.
struct SemiImplicitTuning {
  int watch_interval = 10;       ///< time steps between two calls of the watch
  int refresh_interval = 250;    ///< time steps between two estimates of the stable dt
  double stability_share = 0.5;  ///< of the limit 2/ω: contacts may stiffen in between
  int power_iterations = 30;     ///< for ω, which needs one digit
};

struct SolverTuning {
  PrecisionTuning precision;
  MatrixTuning matrix;
  LineSearchTuning search;
  StepTuning step;
  RegionTuning region;
  QuasiStaticTuning quasi_static;
  ImplicitEulerTuning implicit_euler;
  SemiImplicitTuning semi_implicit;

  /// \throws InvalidInput that names the number that is out of range.
  void validate() const;
};

}  // namespace loosefit::solver

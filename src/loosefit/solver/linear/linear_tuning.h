#pragma once

namespace loosefit::solver {

/// Tuning of the mixed-precision solution of a linear system (NewtonSystem). It changes the cost of
/// a Newton step, and its direction in the third digit. A number without a reason was found by
/// trial.
struct PrecisionTuning {
  /// ‖residual‖/‖g‖ at which conjugate gradients stop [–]. Newton's directions need no more digits.
  double accuracy = 1e-3;
  /// Iterations of conjugate gradients beyond which single precision does not serve the matrix.
  int max_iterations = 8;
  /// Factors in a row that break down in single precision only, after which double precision stays.
  int max_breakdowns = 2;
  /// Longest pause of the test in double precision after matrices that were truly indefinite
  /// [factorisations].
  int max_pause = 64;
};

/// Sizes of the multifrontal factor. They change speed only, and the grouping of sums: constants,
/// so that the bits of a drape do not depend on a setting.
struct MultifrontalTuning {
  /// Work of a subtree from which a task of its own pays [flop]: about 0.2 ms.
  double task_flops = 2e6;
  /// Work of a front from which it is cut into blocks for all threads [flop]; below, the tree has
  /// enough branches.
  double large_front_flops = 6e6;
  /// Rows or columns of such a block: fits the second cache in double precision.
  int front_block = 128;
  /// A pattern with so many times the work of the one that the order was chosen for gets a new
  /// order: else one bad contact made every later factor fifty times dearer
  /// (bench/reports/engine.md).
  double reorder_growth = 1.3;
  /// Particles up to which minimum degree is as good as nested dissection, and quicker.
  int small_graph = 500;
  /// A front is merged into its parent where the explicit zeros stay below `zeros` of the entries;
  /// dense kernels are slow on narrow fronts, so these may hold more (Ashcraft and Grimes 1989).
  struct Merge {
    double columns;  ///< up to so many block columns in the merged front
    double zeros;    ///< share of its entries
  };
  Merge merge[4] = {{8, 0.8}, {16, 0.3}, {40, 0.1}, {1e300, 0.03}};
};
inline constexpr MultifrontalTuning kMultifrontal;

}  // namespace loosefit::solver

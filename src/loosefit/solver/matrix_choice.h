#pragma once
#include <optional>

#include "loosefit/solver/backoff.h"
#include "loosefit/solver/newton_problem.h"
#include "loosefit/solver/solver_tuning.h"

namespace loosefit::solver {

/// Which matrix a Newton step was taken with; each kind is tried when the ones before it are
/// indefinite. The farther down, the safer and the slower.
enum class MatrixKind {
  exact,             ///< the Hessian: quadratic convergence near rest
  mass_shifted,      ///< the Hessian and a little inertia, which holds a few unstable modes only
  half_compression,  ///< half of what compression contributes left in: mostly definite
  projected,         ///< element blocks projected to positive semi-definite: definite but for
                     ///< motions that nothing resists
  regularised,       ///< the same with a growing diagonal shift
};

/// Chooses and factorises the matrix of each Newton step. A kind that was indefinite is tried again
/// after a pause that doubles (Backoff), and the mass shift follows what has lately been enough.
class MatrixChoice {
 public:
  explicit MatrixChoice(const MatrixTuning& tuning)
      : tuning_(tuning),
        exact_backoff_(tuning.max_pause),
        half_backoff_(tuning.max_pause),
        mass_shift_(tuning.first_mass_shift) {}

  /// Factorises the matrix at x with the inertia 1/dt² [1/s²] of the time step, 0 in a static one.
  /// Returns its kind; nothing if even the last regularisation was not enough.
  std::optional<MatrixKind> factorise(NewtonProblem& problem, const particles::VectorField& x,
                                      double per_dt2);

 private:
  std::optional<MatrixKind> try_exact(NewtonProblem& problem, const particles::VectorField& x,
                                      double per_dt2);
  bool try_mass_shift(NewtonProblem& problem);
  bool try_half_compression(NewtonProblem& problem, const particles::VectorField& x,
                            double per_dt2);
  std::optional<MatrixKind> regularise(NewtonProblem& problem, double per_dt2) const;

  MatrixTuning tuning_;
  Backoff exact_backoff_, half_backoff_;
  double mass_shift_;  ///< [1/s²]
};

}  // namespace loosefit::solver

#pragma once
#include <optional>

#include "loosefit/solver/newton_problem.h"
#include "loosefit/solver/solver_tuning.h"

namespace loosefit::solver {

/// Which matrix a Newton step was taken with. The farther down, the safer and the slower.
enum class MatrixKind {
  exact,             ///< the Hessian: quadratic convergence near rest
  half_compression,  ///< half of what compression contributes left in: mostly definite
  projected,         ///< element blocks projected to positive semi-definite: definite but for
                     ///< motions that nothing resists
  regularised,       ///< the same with a growing diagonal shift
};

/// Factorises the matrix of a Newton step at x with the inertia 1/dt² [1/s²] of the time step, 0 in
/// a static one: the first of the kinds that is definite. The exact one is tried after a `calm`
/// step alone, one that was taken whole. Returns the kind; nothing if even the last regularisation
/// was not enough.
std::optional<MatrixKind> factorise(NewtonProblem& problem, const particles::VectorField& x,
                                    double per_dt2, bool calm, const MatrixTuning& tuning);

}  // namespace loosefit::solver

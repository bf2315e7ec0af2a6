#include "loosefit/solver/matrix_choice.h"

#include <algorithm>

namespace loosefit::solver {

std::optional<MatrixKind> MatrixChoice::factorise(NewtonProblem& problem,
                                                  const particles::VectorField& x, double per_dt2) {
  if (tuning_.exact)
    if (const auto kind = try_exact(problem, x, per_dt2)) return kind;
  if (tuning_.half_compression && try_half_compression(problem, x, per_dt2))
    return MatrixKind::half_compression;
  problem.assemble(x, particles::HessianKind::projected);
  if (problem.factorise(per_dt2)) return MatrixKind::projected;
  return regularise(problem, per_dt2);
}

std::optional<MatrixKind> MatrixChoice::try_exact(NewtonProblem& problem,
                                                  const particles::VectorField& x, double per_dt2) {
  if (!exact_backoff_.ready()) return std::nullopt;
  problem.assemble(x, particles::HessianKind::exact);
  if (problem.factorise(per_dt2)) {
    exact_backoff_.succeeded();
    return MatrixKind::exact;
  }
  // The backoff of the exact matrix stays as it is where the shift helps: the next step tries both.
  if (tuning_.mass_shift && per_dt2 == 0 && try_mass_shift(problem))
    return MatrixKind::mass_shifted;
  exact_backoff_.failed();
  return std::nullopt;
}

/// At rest but for a few slow modes of negative curvature: a little inertia holds just them, where
/// the projected matrix would hold everything and creep.
bool MatrixChoice::try_mass_shift(NewtonProblem& problem) {
  if (problem.factorise(mass_shift_)) {
    mass_shift_ = std::max(tuning_.min_mass_shift, mass_shift_ / tuning_.mass_shift_decrease);
    return true;
  }
  mass_shift_ = std::min(tuning_.max_mass_shift, tuning_.mass_shift_increase * mass_shift_);
  return false;
}

/// Compressed cloth is about as stiff against buckling as its compression is strong: without the
/// compression it would be far too stiff there, with half of it the matrix is mostly definite.
bool MatrixChoice::try_half_compression(NewtonProblem& problem, const particles::VectorField& x,
                                        double per_dt2) {
  if (!half_backoff_.ready()) return false;
  problem.assemble(x, particles::HessianKind::half_compression);
  const bool definite = problem.factorise(per_dt2);
  definite ? half_backoff_.succeeded() : half_backoff_.failed();
  return definite;
}

/// The projected matrix is singular where cloth is free to slide: adds what it takes.
std::optional<MatrixKind> MatrixChoice::regularise(NewtonProblem& problem, double per_dt2) const {
  double extra = tuning_.first_regularisation;
  for (int k = 0; k < tuning_.max_regularisations; ++k, extra *= tuning_.regularisation_growth)
    if (problem.factorise(per_dt2 + extra)) return MatrixKind::regularised;
  return std::nullopt;
}

}  // namespace loosefit::solver

#include "loosefit/solver/matrix_choice.h"

namespace loosefit::solver {

std::optional<MatrixKind> factorise(NewtonProblem& problem, const particles::VectorField& x,
                                    double per_dt2, bool calm, const MatrixTuning& tuning) {
  if (calm && tuning.exact) {
    problem.assemble(x, particles::HessianKind::exact);
    if (problem.factorise(per_dt2)) return MatrixKind::exact;
  }
  // Compressed cloth is about as stiff against buckling as its compression is strong: without the
  // compression the matrix would be far too stiff there, with half of it it is mostly definite.
  if (tuning.half_compression) {
    problem.assemble(x, particles::HessianKind::half_compression);
    if (problem.factorise(per_dt2)) return MatrixKind::half_compression;
  }
  problem.assemble(x, particles::HessianKind::projected);
  if (problem.factorise(per_dt2)) return MatrixKind::projected;
  // Singular where cloth is free to slide: adds what it takes.
  double extra = tuning.first_regularisation;
  for (int k = 0; k < tuning.max_regularisations; ++k, extra *= tuning.regularisation_growth)
    if (problem.factorise(per_dt2 + extra)) return MatrixKind::regularised;
  return std::nullopt;
}

}  // namespace loosefit::solver

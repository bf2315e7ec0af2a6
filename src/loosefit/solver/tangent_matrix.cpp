#include "loosefit/solver/tangent_matrix.h"

namespace loosefit::solver {

void TangentMatrix::follow_pattern(const particles::VectorField& x) {
  const std::uint64_t version = system_.pattern_version(x);
  if (matrix_.particles() == system_.particles() && version == pattern_version_) return;
  particles::BlockPattern pattern(system_.particles());
  for (const particles::Energy* e : system_.energies) e->add_pattern(x, pattern);
  pattern.compress();
  if (!matrix_.same_pattern(pattern)) matrix_ = particles::BlockMatrix(pattern);
  pattern_version_ = version;
}

void TangentMatrix::assemble(const particles::VectorField& x, particles::HessianKind kind) {
  follow_pattern(x);
  matrix_.set_zero();
  for (const particles::Energy* e : system_.energies) e->add_hessian(x, matrix_, kind);
}

void TangentMatrix::assemble(const particles::VectorField& x, particles::HessianKind kind,
                             const particles::ActiveSet& active_set) {
  follow_pattern(x);
  for (int i : active_set.particles) matrix_.set_zero(i);
  for (const particles::Energy* e : system_.energies) e->add_hessian(x, matrix_, kind);
}

}  // namespace loosefit::solver

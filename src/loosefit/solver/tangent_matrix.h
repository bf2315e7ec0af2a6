#pragma once
#include <cstdint>

#include "loosefit/solver/particle_system.h"

namespace loosefit::solver {

/// The Hessian of a system's potential. Its pattern is made anew only when that of an energy has
/// changed.
class TangentMatrix {
 public:
  explicit TangentMatrix(const ParticleSystem& system) : system_(system) {}
  void assemble(const particles::VectorField& x, particles::HessianKind kind);
  /// The same while an active set is given (Energy::set_active_set): only columns of its particles,
  /// blocks with both particles inside, are right afterwards.
  void assemble(const particles::VectorField& x, particles::HessianKind kind,
                const particles::ActiveSet& active_set);
  const particles::BlockMatrix& matrix() const { return matrix_; }

 private:
  void follow_pattern(const particles::VectorField& x);

  const ParticleSystem& system_;
  particles::BlockMatrix matrix_;
  std::uint64_t pattern_version_ = 0;
};

}  // namespace loosefit::solver

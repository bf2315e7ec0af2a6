#pragma once
#include <cstdint>

#include "loosefit/solver/particle_system.h"

namespace loosefit::solver {

/// The Hessian of a system's potential over its unknowns: what followers of plates have is at their
/// leaders, and their own rows are zero. Its pattern is made anew only when that of an energy has
/// changed.
class TangentMatrix {
 public:
  explicit TangentMatrix(const ParticleSystem& system) : system_(system) {}
  void assemble(const particles::VectorField& x, particles::HessianKind kind);
  /// The same while an active set is given (Energy::set_active_set): only columns of its particles,
  /// blocks with both particles inside, are right afterwards. \pre no particle of a plate is inside
  void assemble(const particles::VectorField& x, particles::HessianKind kind,
                const particles::ActiveSet& active_set);
  const particles::BlockMatrix& matrix() const { return matrix_; }

 private:
  void follow_pattern(const particles::VectorField& x);
  /// The particles that stand for one, and by how much.
  struct Stand {
    int count = 1;
    std::array<int, 3> particle{};
    std::array<double, 3> weight{1, 0, 0};
  };
  std::vector<Stand> stands() const;
  void gather_blocks();

  const ParticleSystem& system_;
  particles::BlockMatrix matrix_;
  std::uint64_t pattern_version_ = 0;
  struct FollowerBlock {
    int place, row, column;
  };
  std::vector<FollowerBlock> of_followers_;  ///< blocks of matrix_ in a row or column of one
};

}  // namespace loosefit::solver

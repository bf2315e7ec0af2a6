#pragma once
#include <vector>

#include "loosefit/particles/block_matrix.h"
#include "loosefit/particles/energy.h"
#include "loosefit/solver/solver_tuning.h"

namespace loosefit::solver {

/// A few particles that bear nearly all of the unbalanced force, with those around them.
struct ResidualRegion {
  std::vector<int> particles;  ///< rising
  std::vector<int> index;      ///< of every particle in `particles`; −1: outside
  bool empty() const { return particles.empty(); }
};

/// The fewest particles that bear their share of the force, and as many rings round them as the
/// tuning allows. Empty where that takes too many seeds, for then the force is spread out.
/// Particles without force are never seeds. Of `matrix` only the pattern counts. left_out: non-zero
/// for particles that belong to no region; empty: all may.
ResidualRegion residual_region(const particles::BlockMatrix& matrix,
                               const particles::VectorField& force, const RegionTuning& tuning,
                               const std::vector<char>& left_out = {});

/// Which blocks of a matrix those of a part of it are.
struct RestrictedBlocks {
  std::uint64_t of_pattern = 0;  ///< BlockMatrix::pattern_id; 0: none yet
  std::vector<int> source;
};

/// part = rows and columns of the region. `blocks` is brought up to date when the pattern is
/// another one. \pre it was of the same region, or its `of_pattern` is 0
void restrict_to(const ResidualRegion& region, const particles::BlockMatrix& matrix,
                 particles::BlockMatrix& part, RestrictedBlocks& blocks);

}  // namespace loosefit::solver

#pragma once
#include <vector>

#include "loosefit/particles/block_matrix.h"
#include "loosefit/particles/energy.h"

namespace loosefit {

/// A few particles that bear nearly all of the unbalanced force, with those around them.
struct ResidualRegion {
  /// How much of the force, and how far round it.
  struct Bounds {
    double force = 0.95;   ///< share of ‖force‖² that the seeds bear
    double seeds = 0.02;   ///< most seeds, as a share of all particles
    int rings = 8;         ///< most steps from the seeds on the graph of the matrix
    double extent = 0.15;  ///< most particles in the region, as a share of all
  };
  std::vector<int> particles;  ///< rising
  std::vector<int> place;      ///< of every particle among `particles`; −1: outside
  bool empty() const { return particles.empty(); }
};

/// The fewest particles that bear their share of the force, and as many rings round them as the
/// bounds allow. Empty where that takes too many seeds, for then the force is spread out. Particles
/// without force are never seeds. Of `matrix` only the pattern counts.
ResidualRegion residual_region(const BlockMatrix& matrix, const VectorField& force,
                               const ResidualRegion::Bounds& bounds);

/// Which blocks of a matrix those of a part of it are.
struct RestrictedBlocks {
  std::uint64_t of_pattern = 0;  ///< BlockMatrix::pattern_id; 0: none yet
  std::vector<int> source;
};

/// part = rows and columns of the region. `blocks` is brought up to date when the pattern is
/// another one. \pre it was of the same region, or its `of_pattern` is 0
void restrict_to(const ResidualRegion& region, const BlockMatrix& matrix, BlockMatrix& part,
                 RestrictedBlocks& blocks);

}  // namespace loosefit

#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "loosefit/particles/active_set.h"
#include "loosefit/particles/block_matrix.h"

namespace loosefit::particles {

/// Adds the 3 x 3 blocks of elements to a BlockMatrix on all threads: for each place of the matrix
/// the list of its contributions is known, in the order of the elements, so that the bits do not
/// depend on the threads. The places are looked up again only when the pattern changes.
class BlockGather {
 public:
  BlockGather() = default;
  /// `pairs[k]`: the particles (i, j) of element block k; (−1, −1): no such block.
  explicit BlockGather(const std::vector<std::array<int, 2>>& pairs);
  bool empty() const { return row_.empty(); }
  /// Each pair once.
  void add_pattern(BlockPattern& pattern) const;

  /// Block (i, j) of `h` += blocks[k] for all k with pairs[k] = (i, j), or its transpose for (j,
  /// i).
  void add(const std::vector<Mat3>& blocks, BlockMatrix& h) const;
  /// The same in the columns of the active set alone; in all if that is null.
  void add(const std::vector<Mat3>& blocks, BlockMatrix& h, const ActiveSet* active_set) const;

 protected:
  /// So many contributions ahead the memory is asked for what comes; `source_` is longer by that.
  static constexpr int kAhead = 24;

  /// Contributions of the pair at place p of the matrix: [first(p), flipped(p)) as they are,
  /// [flipped(p), first(p + 1)) transposed.
  void find_slots(const BlockMatrix& h) const;
  /// The pairs at places [begin, end).
  void add_places(int begin, int end, const std::vector<Mat3>& blocks, BlockMatrix& h) const;

  std::vector<int> column_start_{0};  ///< of the pairs, as in BlockMatrix
  std::vector<int> row_;
  std::vector<int> first_{0}, flipped_, source_;
  mutable std::vector<int> slot_;
  mutable std::uint64_t pattern_id_ = 0;
};

}  // namespace loosefit::particles

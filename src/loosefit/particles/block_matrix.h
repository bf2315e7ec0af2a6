#pragma once
#include <algorithm>
#include <cstdint>
#include <vector>

#include "loosefit/base/check.h"
#include "loosefit/base/types.h"

namespace loosefit::particles {

/// Set of 3 x 3 blocks of a symmetric matrix; only row ≥ column is kept.
class BlockPattern {
 public:
  explicit BlockPattern(int particles) : rows_of_column_(particles) {
    for (int i = 0; i < particles; ++i) rows_of_column_[i].push_back(i);
  }
  void add(int i, int j) { rows_of_column_[std::min(i, j)].push_back(std::max(i, j)); }
  /// Sorts and removes duplicates; call before use.
  void compress();
  const std::vector<std::vector<int>>& rows_of_column() const { return rows_of_column_; }

 private:
  std::vector<std::vector<int>> rows_of_column_;
};

/// Symmetric block-sparse matrix, lower triangle, compressed columns of 3 x 3 blocks.
class BlockMatrix {
 public:
  BlockMatrix() = default;
  /// \pre pattern is compressed
  explicit BlockMatrix(const BlockPattern& pattern);
  /// The same from columns: rows rising, the diagonal first; column j at [column_start[j],
  /// column_start[j + 1]).
  BlockMatrix(std::vector<int> column_start, std::vector<int> rows);
  bool same_pattern(const BlockPattern& pattern) const;
  void set_zero() { std::fill(blocks_.begin(), blocks_.end(), Mat3::Zero()); }
  /// The blocks of one column.
  void set_zero(int column) {
    std::fill(blocks_.begin() + column_start_[column], blocks_.begin() + column_start_[column + 1],
              Mat3::Zero());
  }
  int particles() const { return static_cast<int>(column_start_.size()) - 1; }

  /// Adds `block` at (i, j), and by symmetry its transpose at (j, i). For i ≠ j call it once per
  /// unordered pair. \pre the block is in the pattern
  void add(int i, int j, const Mat3& block) {
    if (i >= j)
      blocks_[find(i, j)] += block;
    else
      blocks_[find(j, i)] += block.transpose();
  }
  /// Index of block (i, j), i ≥ j, in blocks(). \pre the block is in the pattern
  int slot(int i, int j) const { return find(i, j); }
  /// Differs between matrices whose patterns were made separately; for callers that keep slots.
  std::uint64_t pattern_id() const { return pattern_id_; }
  /// y += A x (both triangles).
  void add_product(const std::vector<Vec3>& x, std::vector<Vec3>& y) const;

  const std::vector<int>& column_start() const { return column_start_; }
  const std::vector<int>& rows() const { return rows_; }
  const std::vector<Mat3>& blocks() const { return blocks_; }
  Mat3& block(int k) { return blocks_[k]; }

 private:
  int find(int row, int column) const {
    const auto first = rows_.begin() + column_start_[column];
    const auto last = rows_.begin() + column_start_[column + 1];
    const auto at = std::lower_bound(first, last, row);
    LOOSEFIT_ASSERT(at != last && *at == row);
    return static_cast<int>(at - rows_.begin());
  }
  std::uint64_t pattern_id_ = 0;
  std::vector<int> column_start_{0};
  std::vector<int> rows_;
  std::vector<Mat3> blocks_;
};

}  // namespace loosefit::particles

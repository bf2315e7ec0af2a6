#include "loosefit/particles/block_matrix.h"

#include <tbb/parallel_for.h>

#include <atomic>
#include <functional>

namespace loosefit::particles {

void BlockPattern::compress() {
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, rows_of_column_.size(), 512),
                    [&](const tbb::blocked_range<std::size_t>& columns) {
                      for (std::size_t j = columns.begin(); j < columns.end(); ++j) {
                        std::vector<int>& rows = rows_of_column_[j];
                        std::sort(rows.begin(), rows.end());
                        rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
                      }
                    });
}

namespace {

std::uint64_t new_pattern_id() {
  static std::atomic<std::uint64_t> made{0};
  return ++made;
}

}  // namespace

BlockMatrix::BlockMatrix(std::vector<int> column_start, std::vector<int> rows)
    : pattern_id_(new_pattern_id()),
      column_start_(std::move(column_start)),
      rows_(std::move(rows)),
      blocks_(rows_.size(), Mat3::Zero()) {}

BlockMatrix::BlockMatrix(const BlockPattern& pattern) : pattern_id_(new_pattern_id()) {
  const auto& columns = pattern.rows_of_column();
  LOOSEFIT_ASSERT(std::all_of(columns.begin(), columns.end(), [](const std::vector<int>& rows) {
    return std::adjacent_find(rows.begin(), rows.end(), std::greater_equal<>()) == rows.end();
  }));
  column_start_.reserve(columns.size() + 1);
  for (const auto& rows : columns) {
    rows_.insert(rows_.end(), rows.begin(), rows.end());
    column_start_.push_back(static_cast<int>(rows_.size()));
  }
  blocks_.assign(rows_.size(), Mat3::Zero());
}

bool BlockMatrix::same_pattern(const BlockPattern& pattern) const {
  const auto& columns = pattern.rows_of_column();
  if (static_cast<int>(columns.size()) != particles()) return false;
  for (std::size_t j = 0; j < columns.size(); ++j) {
    if (static_cast<int>(columns[j].size()) != column_start_[j + 1] - column_start_[j])
      return false;
    if (!std::equal(columns[j].begin(), columns[j].end(), rows_.begin() + column_start_[j]))
      return false;
  }
  return true;
}

void BlockMatrix::add_product(const std::vector<Vec3>& x, std::vector<Vec3>& y) const {
  for (int j = 0; j < particles(); ++j) {
    Vec3 sum = blocks_[column_start_[j]] * x[j];
    for (int k = column_start_[j] + 1; k < column_start_[j + 1]; ++k) {
      const int i = rows_[k];
      y[i] += blocks_[k] * x[j];
      sum += blocks_[k].transpose() * x[i];
    }
    y[j] += sum;
  }
}

}  // namespace loosefit::particles

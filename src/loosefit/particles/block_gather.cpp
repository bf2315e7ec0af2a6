#include "loosefit/particles/block_gather.h"

#include <algorithm>

#include "loosefit/particles/tile.h"

namespace loosefit::particles {
namespace {

/// Sum of 3 x 3 blocks in registers.
struct Nine {
  Quad low{}, high{};
  double last = 0;
  void add(const double* b) {
    low += *reinterpret_cast<const Quad*>(b);
    high += *reinterpret_cast<const Quad*>(b + 4);
    last += b[8];
  }
  double operator[](int i) const { return i < 4 ? low[i] : i < 8 ? high[i - 4] : last; }
};

}  // namespace

BlockGather::BlockGather(const std::vector<std::array<int, 2>>& pairs) {
  int particles = 0;
  for (const auto& [i, j] : pairs) particles = std::max({particles, i + 1, j + 1});
  // Counting sort by column, then within a column by row, as they are before flipped.
  std::vector<int> begin(particles + 1, 0);
  for (const auto& [i, j] : pairs)
    if (i >= 0) ++begin[std::min(i, j) + 1];
  for (int c = 0; c < particles; ++c) begin[c + 1] += begin[c];
  std::vector<std::uint64_t> entry(begin.back());  // row, flip, source
  std::vector<int> next(begin.begin(), begin.end() - 1);
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const auto [i, j] = pairs[k];
    if (i < 0) continue;
    entry[next[std::min(i, j)]++] = std::uint64_t(std::max(i, j)) << 33 |
                                    std::uint64_t(i < j) << 32 | static_cast<std::uint32_t>(k);
  }
  for_ranges(particles, 64, [&](int from, int to) {
    for (int c = from; c < to; ++c)
      std::sort(entry.begin() + begin[c], entry.begin() + begin[c + 1]);
  });
  const auto row_of = [](std::uint64_t e) { return static_cast<int>(e >> 33); };
  const auto flip_of = [](std::uint64_t e) { return (e >> 32 & 1) != 0; };
  source_.reserve(entry.size());
  for (int c = 0; c < particles; ++c) {
    for (int e = begin[c]; e < begin[c + 1];) {
      const int row = row_of(entry[e]);
      row_.push_back(row);
      const auto take = [&](bool flip) {
        while (e < begin[c + 1] && row_of(entry[e]) == row && flip_of(entry[e]) == flip)
          source_.push_back(static_cast<int>(entry[e++] & 0xffffffff));
        return static_cast<int>(source_.size());
      };
      flipped_.push_back(take(false));
      first_.push_back(take(true));
    }
    column_start_.push_back(static_cast<int>(row_.size()));
  }
  source_.resize(source_.size() + kAhead, 0);
}

void BlockGather::add_pattern(BlockPattern& pattern) const {
  for (std::size_t c = 0; c + 1 < column_start_.size(); ++c)
    for (int k = column_start_[c]; k < column_start_[c + 1]; ++k)
      if (row_[k] != static_cast<int>(c)) pattern.add(row_[k], static_cast<int>(c));
}

void BlockGather::find_slots(const BlockMatrix& h) const {
  if (pattern_id_ == h.pattern_id()) return;
  slot_.resize(row_.size());
  for_ranges(static_cast<int>(column_start_.size()) - 1, 512, [&](int begin, int end) {
    for (int c = begin; c < end; ++c) {
      int slot = h.column_start()[c];  // the rows of both rise
      for (int k = column_start_[c]; k < column_start_[c + 1]; ++k) {
        while (h.rows()[slot] < row_[k]) ++slot;
        slot_[k] = slot;
      }
    }
  });
  pattern_id_ = h.pattern_id();
}

void BlockGather::add_places(int begin, int end, const std::vector<Mat3>& blocks,
                             BlockMatrix& h) const {
  for (int p = begin; p < end; ++p) {
    Nine sum, turned;
    const auto take = [&](int k, Nine& to) {
      __builtin_prefetch(blocks[source_[k + kAhead]].data());
      __builtin_prefetch(blocks[source_[k + kAhead]].data() + 8);
      to.add(blocks[source_[k]].data());
    };
    for (int k = first_[p]; k < flipped_[p]; ++k) take(k, sum);
    for (int k = flipped_[p]; k < first_[p + 1]; ++k) take(k, turned);
    double* to = h.block(slot_[p]).data();
    for (int c = 0; c < 3; ++c)
      for (int r = 0; r < 3; ++r) to[3 * c + r] += sum[3 * c + r] + turned[3 * r + c];
  }
}

void BlockGather::add(const std::vector<Mat3>& blocks, BlockMatrix& h) const {
  find_slots(h);
  for_ranges(static_cast<int>(row_.size()), 512,
             [&](int begin, int end) { add_places(begin, end, blocks, h); });
}

void BlockGather::add(const std::vector<Mat3>& blocks, BlockMatrix& h,
                      const ActiveSet* active_set) const {
  if (!active_set) return add(blocks, h);
  find_slots(h);
  const int columns = static_cast<int>(column_start_.size()) - 1;
  for_ranges(static_cast<int>(active_set->particles.size()), 64, [&](int begin, int end) {
    for (int k = begin; k < end; ++k)
      if (const int column = active_set->particles[k]; column < columns)
        add_places(column_start_[column], column_start_[column + 1], blocks, h);
  });
}

}  // namespace loosefit::particles

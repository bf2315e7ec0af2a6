#include "loosefit/geometry/box_pairs.h"

#include <algorithm>
#include <cmath>

namespace loosefit {
namespace {

/// Boxes sorted into the cells of a dense grid (compressed rows).
class BoxGrid {
 public:
  BoxGrid(const std::vector<Box3>& boxes, const Box3& bounds, double cell) : boxes_(boxes) {
    origin_ = bounds.min();
    const Vec3 extent = bounds.sizes();
    constexpr double kMaxCells = 4e6;  // a few 10 MB of counters at the most
    inverse_ = 1.0 / cell;
    for (;;) {
      for (int k = 0; k < 3; ++k)
        size_[k] = 1 + static_cast<long>(std::min(extent[k] * inverse_, 1e9));
      if (double(size_[0]) * double(size_[1]) * double(size_[2]) <= kMaxCells) break;
      inverse_ *= 0.5;
    }
    start_.assign(size_[0] * size_[1] * size_[2] + 1, 0);
    lower_.resize(boxes.size());
    upper_.resize(boxes.size());
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      lower_[i] = cell_of(boxes[i].min());
      upper_[i] = cell_of(boxes[i].max());
      for_cells(lower_[i], upper_[i], [&](long c, const Cell&) { ++start_[c + 1]; });
    }
    for (std::size_t c = 1; c < start_.size(); ++c) start_[c] += start_[c - 1];
    entries_.resize(start_.back());
    std::vector<int> fill(start_.begin(), start_.end() - 1);
    for (std::size_t i = 0; i < boxes.size(); ++i)
      for_cells(lower_[i], upper_[i],
                [&](long c, const Cell&) { entries_[fill[c]++] = static_cast<int>(i); });
  }

  /// Calls visit(j) once for every box j of the grid that overlaps `box`.
  template <class Visit>
  void query(const Box3& box, Visit visit) const {
    const Cell lower = cell_of(box.min()), upper = cell_of(box.max());
    for_cells(lower, upper, [&](long c, const Cell& cell) {
      for (int k = start_[c]; k < start_[c + 1]; ++k) {
        const int j = entries_[k];
        // A pair is reported only in the first cell that both boxes touch.
        bool first = true;
        for (int d = 0; d < 3; ++d) first &= cell[d] == std::max(lower[d], lower_[j][d]);
        if (first && box.intersects(boxes_[j])) visit(j);
      }
    });
  }

 private:
  using Cell = std::array<long, 3>;
  Cell cell_of(const Vec3& p) const {
    Cell c;
    for (int k = 0; k < 3; ++k)
      c[k] = std::clamp(static_cast<long>(std::floor((p[k] - origin_[k]) * inverse_)), 0L,
                        size_[k] - 1);
    return c;
  }
  template <class F>
  void for_cells(const Cell& lower, const Cell& upper, F f) const {
    for (long z = lower[2]; z <= upper[2]; ++z)
      for (long y = lower[1]; y <= upper[1]; ++y)
        for (long x = lower[0]; x <= upper[0]; ++x)
          f((z * size_[1] + y) * size_[0] + x, Cell{x, y, z});
  }
  const std::vector<Box3>& boxes_;
  Vec3 origin_;
  double inverse_ = 1;
  Cell size_{1, 1, 1};
  std::vector<int> start_, entries_;
  std::vector<Cell> lower_, upper_;
};

Box3 bounds_of(const std::vector<Box3>& boxes, double& mean_size) {
  Box3 bounds;
  double sum = 0;
  for (const Box3& b : boxes) {
    bounds.extend(b);
    sum += b.sizes().maxCoeff();
  }
  mean_size = boxes.empty() ? 1.0 : std::max(sum / double(boxes.size()), 1e-9);
  return bounds;
}

}  // namespace

std::vector<std::pair<int, int>> overlapping_boxes(const std::vector<Box3>& a,
                                                   const std::vector<Box3>& b) {
  std::vector<std::pair<int, int>> pairs;
  if (a.empty() || b.empty()) return pairs;
  double mean = 1;
  const Box3 bounds = bounds_of(b, mean);
  const BoxGrid grid(b, bounds, 1.5 * mean);
  for (int i = 0; i < static_cast<int>(a.size()); ++i) {
    if (!bounds.intersects(a[i])) continue;
    const std::size_t from = pairs.size();
    grid.query(a[i], [&](int j) { pairs.emplace_back(i, j); });
    std::sort(pairs.begin() + static_cast<long>(from), pairs.end());
  }
  return pairs;
}

std::vector<std::pair<int, int>> overlapping_boxes(const std::vector<Box3>& boxes) {
  std::vector<std::pair<int, int>> pairs;
  if (boxes.empty()) return pairs;
  double mean = 1;
  const Box3 bounds = bounds_of(boxes, mean);
  const BoxGrid grid(boxes, bounds, 1.5 * mean);
  for (int i = 0; i < static_cast<int>(boxes.size()); ++i) {
    const std::size_t from = pairs.size();
    grid.query(boxes[i], [&](int j) {
      if (i < j) pairs.emplace_back(i, j);
    });
    std::sort(pairs.begin() + static_cast<long>(from), pairs.end());
  }
  return pairs;
}

}  // namespace loosefit

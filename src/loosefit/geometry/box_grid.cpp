#include "loosefit/geometry/box_grid.h"

namespace loosefit {

void BoxGrid::build(const std::vector<Box3>& boxes) {
  constexpr double kMaxCells = 4e6;  // a few 10 MB of counters at the most
  constexpr double kCell = 1.0;      // cell in mean box sizes
  boxes_ = boxes;
  bounds_.setEmpty();
  double sum = 0;
  for (const Box3& b : boxes) {
    bounds_.extend(b);
    sum += b.sizes().maxCoeff();
  }
  if (boxes.empty()) return;
  inverse_ = 1 / std::max(kCell * sum / static_cast<double>(boxes.size()), 1e-9);
  const Vec3 extent = bounds_.sizes();
  for (;;) {
    double cells = 1;
    for (int k = 0; k < 3; ++k) {
      size_[k] = 1 + static_cast<int>(std::min(extent[k] * inverse_, 1e9));
      cells *= size_[k];
    }
    if (cells <= kMaxCells) break;
    inverse_ *= 0.5;
  }
  start_.assign(static_cast<std::size_t>(size_[0]) * size_[1] * size_[2] + 1, 0);
  lower_.resize(boxes.size());
  upper_.resize(boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    lower_[i] = cell_of(boxes[i].min());
    upper_[i] = cell_of(boxes[i].max());
    for_cells(lower_[i], upper_[i], [&](int c, const Cell&) { ++start_[c]; });
  }
  // Counts become ends of the cells, and filling from the back turns ends into starts.
  for (std::size_t c = 1; c < start_.size(); ++c) start_[c] += start_[c - 1];
  entries_.resize(start_.back());
  for (std::size_t i = boxes.size(); i-- > 0;)
    for_cells(lower_[i], upper_[i],
              [&](int c, const Cell&) { entries_[--start_[c]] = static_cast<int>(i); });
}

}  // namespace loosefit

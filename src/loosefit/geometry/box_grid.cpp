#include "loosefit/geometry/box_grid.h"

#include <algorithm>
#include <cmath>

namespace loosefit::geometry {

void BoxGrid::build(const std::vector<Box3>& boxes) {
  // A few boxes that lie far apart need no more cells than many: 16 for each.
  const double most_cells = std::clamp(16.0 * static_cast<double>(boxes.size()), 4096.0, 4e6);
  constexpr double kCell = 1.0;  // cell in mean box sizes
  boxes_ = boxes;
  bounds_.setEmpty();
  double sum = 0;
  for (const Box3& b : boxes) {
    bounds_.extend(b);
    sum += b.sizes().maxCoeff();
  }
  busy_.clear();
  if (boxes.empty()) return;
  inverse_ = 1 / std::max(kCell * sum / static_cast<double>(boxes.size()), 1e-9);
  const Vec3 extent = bounds_.sizes();
  for (;;) {
    double cells = 1;
    for (int k = 0; k < 3; ++k) {
      size_[k] = 1 + static_cast<int>(std::min(extent[k] * inverse_, 1e9));
      cells *= size_[k];
    }
    if (cells <= most_cells) break;
    inverse_ *= 0.5;
  }
  rounded_.resize(boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i)
    for (int d = 0; d < 3; ++d) {
      rounded_[i][d] = round_down(boxes[i].min()[d]);
      rounded_[i][d + 3] = round_up(boxes[i].max()[d]);
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
  for (std::size_t c = 0; c + 1 < start_.size(); ++c)
    if (start_[c + 1] - start_[c] > 1) busy_.push_back(static_cast<int>(c));
}

void BoxGrid::gather_sides(const int* boxes, int n, std::vector<float>& sides) const {
  sides.resize(static_cast<std::size_t>(n) * 6);
  for (int i = 0; i < n; ++i)
    for (int d = 0; d < 6; ++d) sides[d * n + i] = rounded_[boxes[i]][d];
}

void BoxGrid::compare_sides(const float* sides, int n, int a, char* meets) {
  const float *x0 = sides, *y0 = x0 + n, *z0 = y0 + n, *x1 = z0 + n, *y1 = x1 + n, *z1 = y1 + n;
  const float ax0 = x0[a], ay0 = y0[a], az0 = z0[a], ax1 = x1[a], ay1 = y1[a], az1 = z1[a];
  for (int b = a + 1; b < n; ++b)
    meets[b] = static_cast<char>((x0[b] <= ax1) & (ax0 <= x1[b]) & (y0[b] <= ay1) & (ay0 <= y1[b]) &
                                 (z0[b] <= az1) & (az0 <= z1[b]));
}

}  // namespace loosefit::geometry

#include "loosefit/geometry/box_pairs.h"

namespace loosefit::geometry {
std::vector<std::pair<int, int>> overlapping_boxes(const std::vector<Box3>& a,
                                                   const std::vector<Box3>& b) {
  BoxGrid grid;
  grid.build(b);
  std::vector<std::pair<int, int>> pairs;
  for (int i = 0; i < static_cast<int>(a.size()); ++i) {
    const auto from = static_cast<std::ptrdiff_t>(pairs.size());
    grid.query(a[i], [&](int j) { pairs.emplace_back(i, j); });
    std::sort(pairs.begin() + from, pairs.end());
  }
  return pairs;
}

std::vector<std::pair<int, int>> overlapping_boxes(const std::vector<Box3>& boxes) {
  BoxGrid grid;
  grid.build(boxes);
  std::vector<std::pair<int, int>> pairs;
  grid.visit_pairs(0, grid.busy_cells(), [&](int i, int j) { pairs.emplace_back(i, j); });
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace loosefit::geometry

#include "loosefit/geometry/box_pairs.h"

namespace loosefit {
namespace {

template <class Keep>
std::vector<std::pair<int, int>> collect(const std::vector<Box3>& a, const std::vector<Box3>& b,
                                         Keep keep) {
  BoxGrid grid;
  grid.build(b);
  std::vector<std::pair<int, int>> pairs;
  for (int i = 0; i < static_cast<int>(a.size()); ++i) {
    const auto from = static_cast<std::ptrdiff_t>(pairs.size());
    grid.query(a[i], [&](int j) {
      if (keep(i, j)) pairs.emplace_back(i, j);
    });
    std::sort(pairs.begin() + from, pairs.end());
  }
  return pairs;
}

}  // namespace

std::vector<std::pair<int, int>> overlapping_boxes(const std::vector<Box3>& a,
                                                   const std::vector<Box3>& b) {
  return collect(a, b, [](int, int) { return true; });
}

std::vector<std::pair<int, int>> overlapping_boxes(const std::vector<Box3>& boxes) {
  return collect(boxes, boxes, [](int i, int j) { return i < j; });
}

}  // namespace loosefit

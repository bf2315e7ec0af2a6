#pragma once
#include <algorithm>
#include <array>
#include <vector>

#include "loosefit/base/types.h"
#include "loosefit/geometry/box.h"

namespace loosefit::geometry {

/// Boxes sorted into the cells of a dense uniform grid (compressed rows). Best for many boxes of
/// similar size. Memory is kept from one build to the next; queries may run on many threads.
class BoxGrid {
 public:
  /// Takes the place of whatever was in the grid.
  void build(const std::vector<Box3>& boxes);

  /// Calls visit(j) once for every box j of the grid that overlaps `box`, in an order that depends
  /// on the boxes alone. Closed boxes: touching counts as overlap.
  template <class Visit>
  void query(const Box3& box, Visit visit) const {
    if (boxes_.empty() || !bounds_.intersects(box)) return;
    const Cell lower = cell_of(box.min()), upper = cell_of(box.max());
    for_cells(lower, upper, [&](int c, const Cell& cell) {
      for (int k = start_[c]; k < start_[c + 1]; ++k) {
        const int j = entries_[k];
        if (!box.intersects(boxes_[j])) continue;
        // A pair is reported only in the first cell that both boxes touch.
        bool first = true;
        for (int d = 0; d < 3; ++d) first &= cell[d] == std::max(lower[d], lower_[j][d]);
        if (first) visit(j);
      }
    });
  }

  /// Cells that hold two boxes or more, for visit_pairs.
  std::size_t busy_cells() const { return busy_.size(); }
  /// Calls visit(i, j), i < j, for the overlapping boxes that meet in the busy cells [from, to).
  /// All busy cells together give every pair of the grid just once.
  template <class Visit>
  void visit_pairs(std::size_t from, std::size_t to, Visit visit) const {
    std::vector<float> sides;
    std::vector<char> meets;
    for (std::size_t k = from; k < to; ++k) {
      const int c = busy_[k], n = start_[c + 1] - start_[c];
      const int* const entries = entries_.data() + start_[c];
      const Cell cell{c % size_[0], c / size_[0] % size_[1], c / size_[0] / size_[1]};
      gather_sides(entries, n, sides);
      meets.resize(n);
      for (int a = 0; a + 1 < n; ++a) {
        compare_sides(sides.data(), n, a, meets.data());
        for (int b = a + 1; b < n; ++b) {
          if (!meets[b]) continue;
          const int i = entries[a], j = entries[b];
          bool first = true;
          for (int d = 0; d < 3; ++d) first &= cell[d] == std::max(lower_[i][d], lower_[j][d]);
          if (first && boxes_[i].intersects(boxes_[j])) visit(i, j);
        }
      }
    }
  }

 private:
  using Cell = std::array<int, 3>;
  Cell cell_of(const Vec3& p) const {
    Cell c;
    for (int k = 0; k < 3; ++k)  // !(t > 0) catches what is not a number, too
      if (const double t = (p[k] - bounds_.min()[k]) * inverse_; !(t > 0))
        c[k] = 0;
      else
        c[k] = t < size_[k] - 1 ? static_cast<int>(t) : size_[k] - 1;
    return c;
  }
  template <class F>
  void for_cells(const Cell& lower, const Cell& upper, F f) const {
    for (int z = lower[2]; z <= upper[2]; ++z)
      for (int y = lower[1]; y <= upper[1]; ++y)
        for (int x = lower[0]; x <= upper[0]; ++x)
          f((z * size_[1] + y) * size_[0] + x, Cell{x, y, z});
  }

  /// The rounded sides of some boxes as six rows of n numbers.
  void gather_sides(const int* boxes, int n, std::vector<float>& sides) const;
  /// Whether box a meets each box after it.
  static void compare_sides(const float* sides, int n, int a, char* meets);

  Box3 bounds_;
  double inverse_ = 1;
  Cell size_{1, 1, 1};
  std::vector<Box3> boxes_;
  std::vector<std::array<float, 6>> rounded_;  ///< sides in single precision, rounded outwards
  std::vector<int> start_, entries_, busy_;
  std::vector<Cell> lower_, upper_;
};

}  // namespace loosefit::geometry

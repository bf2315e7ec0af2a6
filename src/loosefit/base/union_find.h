#pragma once
#include <algorithm>
#include <numeric>
#include <vector>

namespace loosefit {

/// Disjoint sets of 0 … n−1; the smallest member stands for its set.
class UnionFind {
 public:
  explicit UnionFind(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0); }
  int find(int i) {
    while (parent_[std::size_t(i)] != i) {
      i = parent_[std::size_t(i)] = parent_[std::size_t(parent_[std::size_t(i)])];
    }
    return i;
  }
  /// True when they were in two sets before.
  bool unite(int a, int b) {
    const int root_a = find(a), root_b = find(b);
    parent_[std::size_t(std::max(root_a, root_b))] = std::min(root_a, root_b);
    return root_a != root_b;
  }

 private:
  std::vector<int> parent_;
};

}  // namespace loosefit

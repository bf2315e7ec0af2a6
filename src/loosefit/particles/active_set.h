#pragma once
#include <vector>

namespace loosefit::particles {

/// Active set: the particles that move while all others rest (ActiveSetUser).
struct ActiveSet {
  std::vector<int> particles;  ///< rising
  std::vector<char> inside;    ///< of every particle: whether it is one of them
  /// Whether one of the first `count` particles of the stencil is inside.
  template <class Stencil>
  bool touches(const Stencil& stencil, int count) const {
    for (int k = 0; k < count; ++k)
      if (inside[stencil[k]]) return true;
    return false;
  }
};

/// The indices 0 … n − 1, or a subset of them in rising order.
class IndexSubset {
 public:
  IndexSubset() = default;
  /// All of 0 … n − 1.
  explicit IndexSubset(std::size_t n) : size_(static_cast<int>(n)) {}
  /// Those of 0 … n − 1 for which include(k).
  template <class Include>
  IndexSubset(std::size_t n, const Include& include) : all_(false) {
    for (int k = 0; k < static_cast<int>(n); ++k)
      if (include(k)) list_.push_back(k);
    size_ = static_cast<int>(list_.size());
  }
  int size() const { return size_; }
  int operator[](int k) const { return all_ ? k : list_[k]; }

 private:
  bool all_ = true;
  int size_ = 0;
  std::vector<int> list_;
};

}  // namespace loosefit::particles

#pragma once
#include <vector>

namespace loosefit {

/// Some of the particles: those that move while all others rest (Energy::set_focus).
struct Focus {
  std::vector<int> particles;  ///< rising
  std::vector<char> inside;    ///< of every particle: whether it is one of them
  /// Whether one of the first `count` of these is inside.
  template <class Stencil>
  bool touches(const Stencil& some, int count) const {
    for (int k = 0; k < count; ++k)
      if (inside[some[k]]) return true;
    return false;
  }
};

/// The numbers 0 … n − 1, or some of them.
class Chosen {
 public:
  Chosen() = default;
  explicit Chosen(std::size_t n) : size_(static_cast<int>(n)) {}
  /// Those of 0 … n − 1 for which wanted(k).
  template <class Wanted>
  Chosen(std::size_t n, const Wanted& wanted) : all_(false) {
    for (int k = 0; k < static_cast<int>(n); ++k)
      if (wanted(k)) list_.push_back(k);
    size_ = static_cast<int>(list_.size());
  }
  int size() const { return size_; }
  int operator[](int k) const { return all_ ? k : list_[k]; }

 private:
  bool all_ = true;
  int size_ = 0;
  std::vector<int> list_;
};

}  // namespace loosefit

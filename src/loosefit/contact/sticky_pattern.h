#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "loosefit/particles/block_matrix.h"

namespace loosefit::contact {

/// The blocks of a matrix that changing contacts have needed lately. It only grows while contacts
/// come and go, so that a matrix and its symbolic factor last; when more than twice the blocks in
/// use plus BarrierTuning::pattern_slack have piled up it shrinks to those in use.
class StickyPattern {
 public:
  explicit StickyPattern(int particles) : rows_of_column_(particles) {}

  /// A new set of contacts follows: `use` each of them, then `end`; `complete`: there are no
  /// others, so that what has not been used may be forgotten.
  void begin() { ++now_, used_ = 0; }
  template <class Stencil>
  void use(const Stencil& particles, int count) {
    for (int a = 0; a < count; ++a)
      for (int b = 0; b < a; ++b) use_block(particles[a], particles[b]);
  }
  void end(bool complete = true);

  /// Grows whenever the set of blocks changes.
  std::uint64_t version() const { return version_; }
  /// Goes back to an earlier set of blocks, under a version that neither has had.
  void recall(const StickyPattern& earlier);
  std::size_t size() const { return size_; }
  std::size_t used() const { return used_; }
  void add_to(particles::BlockPattern& pattern) const;

 private:
  struct Entry {
    int row;
    std::uint32_t last_use;
  };
  void use_block(int i, int j);
  std::vector<std::vector<Entry>> rows_of_column_;
  std::size_t size_ = 0, used_ = 0;
  std::uint32_t now_ = 0;
  std::uint64_t version_ = 0;
  bool grown_ = false;
};

}  // namespace loosefit::contact

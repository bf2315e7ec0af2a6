#include "loosefit/placement/resample.h"

#include <numeric>
#include <random>
#include <utility>

namespace loosefit::placement {
namespace {

/// Uniform index below `n`. std::uniform_int_distribution differs between standard libraries; the
/// bias of the high product is below n / 2^64.
int below(std::mt19937_64& generator, int n) {
  __extension__ using Wide = unsigned __int128;
  return static_cast<int>((static_cast<Wide>(generator()) * static_cast<Wide>(n)) >> 64);
}

}  // namespace

std::vector<std::vector<int>> bootstrap_draws(int n, int count, std::uint64_t seed) {
  std::mt19937_64 generator(seed);
  std::vector<std::vector<int>> draws(count, std::vector<int>(n));
  for (auto& draw : draws)
    for (int& index : draw) index = below(generator, n);
  return draws;
}

std::vector<int> shuffled(int n, std::uint64_t seed) {
  std::mt19937_64 generator(seed);
  std::vector<int> order(n);
  std::iota(order.begin(), order.end(), 0);
  for (int i = n - 1; i > 0; --i) std::swap(order[i], order[below(generator, i + 1)]);
  return order;
}

}  // namespace loosefit::placement

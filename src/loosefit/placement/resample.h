#pragma once
#include <cstdint>
#include <vector>

namespace loosefit::placement {

/// Index draws of a bootstrap: `count` rows of n indices from 0 to n − 1, with replacement. Depends
/// on n, count and seed only, not on the standard library.
std::vector<std::vector<int>> bootstrap_draws(int n, int count, std::uint64_t seed);

/// The indices 0 … n − 1 in random order (Fisher and Yates 1938), by the seed only.
std::vector<int> shuffled(int n, std::uint64_t seed);

}  // namespace loosefit::placement

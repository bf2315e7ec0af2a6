#pragma once
#include <vector>

namespace loosefit::pattern {

/// The assignment of rows to columns of a square matrix with the least sum, column by row
/// (Hungarian method: Kuhn 1955, shortest augmenting paths after Jonker and Volgenant 1987). O(n³).
std::vector<int> least_cost_assignment(const std::vector<std::vector<double>>& cost);

}  // namespace loosefit::pattern

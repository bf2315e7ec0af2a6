#include "loosefit/pattern/least_cost.h"

#include <limits>

namespace loosefit::pattern {

std::vector<int> least_cost_assignment(const std::vector<std::vector<double>>& cost) {
  const int n = static_cast<int>(cost.size());
  constexpr double kFar = std::numeric_limits<double>::infinity();
  // Potentials of rows and columns; row of each column; index 0 stands for none.
  std::vector<double> u(n + 1, 0), v(n + 1, 0);
  std::vector<int> row(n + 1, 0), way(n + 1, 0);
  for (int i = 1; i <= n; ++i) {
    row[0] = i;
    int column = 0;
    std::vector<double> least(n + 1, kFar);
    std::vector<char> used(n + 1, 0);
    do {
      used[column] = 1;
      const int at = row[column];
      double delta = kFar;
      int next = 0;
      for (int j = 1; j <= n; ++j) {
        if (used[j]) continue;
        const double reduced = cost[at - 1][j - 1] - u[at] - v[j];
        if (reduced < least[j]) least[j] = reduced, way[j] = column;
        if (least[j] < delta) delta = least[j], next = j;
      }
      for (int j = 0; j <= n; ++j)
        if (used[j])
          u[row[j]] += delta, v[j] -= delta;
        else
          least[j] -= delta;
      column = next;
    } while (row[column] != 0);
    while (column != 0) {
      row[column] = row[way[column]];
      column = way[column];
    }
  }
  std::vector<int> assigned(n, -1);
  for (int j = 1; j <= n; ++j) assigned[row[j] - 1] = j - 1;
  return assigned;
}

}  // namespace loosefit::pattern

#include "loosefit/solver/linear/multifrontal/front_tree.h"

#include <algorithm>
#include <numeric>

#include "loosefit/solver/linear/linear_tuning.h"

namespace loosefit::solver {
namespace {

using Lists = std::vector<std::vector<int>>;

/// Rows > column of the permuted graph.
Lists permuted(const std::vector<int>& column_start, const std::vector<int>& rows,
               const std::vector<int>& number) {
  const int n = static_cast<int>(number.size());
  Lists below(n);
  for (int j = 0; j < n; ++j)
    for (int k = column_start[j]; k < column_start[j + 1]; ++k)
      if (rows[k] != j) {
        const auto [low, high] = std::minmax(number[j], number[rows[k]]);
        below[low].push_back(high);
      }
  return below;
}

/// Parent of each column in the elimination tree (Liu 1990).
std::vector<int> elimination_tree(const Lists& below) {
  const int n = static_cast<int>(below.size());
  Lists left(n);  // columns < row
  for (int j = 0; j < n; ++j)
    for (int i : below[j]) left[i].push_back(j);
  std::vector<int> parent(n, -1), ancestor(n, -1);
  for (int i = 0; i < n; ++i)
    for (int j : left[i])
      for (int k = j; k != -1 && k != i;) {
        const int next = ancestor[k];
        ancestor[k] = i;
        if (next == -1) parent[k] = i;
        k = next;
      }
  return parent;
}

std::vector<int> postorder(const std::vector<int>& parent) {
  const int n = static_cast<int>(parent.size());
  Lists children(n);
  for (int j = n - 1; j >= 0; --j)
    if (parent[j] >= 0) children[parent[j]].push_back(j);
  std::vector<int> order, stack, next(n, 0);
  for (int root = 0; root < n; ++root) {
    if (parent[root] >= 0) continue;
    stack.push_back(root);
    while (!stack.empty()) {
      const int j = stack.back();
      const int open = static_cast<int>(children[j].size()) - next[j];
      if (open > 0) {
        stack.push_back(children[j][open - 1]);
        ++next[j];
      } else {
        order.push_back(j);
        stack.pop_back();
      }
    }
  }
  return order;
}

/// Rows below the diagonal in every column of the factor.
Lists factor_structure(const Lists& below, const std::vector<int>& parent) {
  const int n = static_cast<int>(below.size());
  Lists structure(n), children(n);
  for (int j = 0; j < n; ++j)
    if (parent[j] >= 0) children[parent[j]].push_back(j);
  std::vector<int> mark(n, -1);
  for (int j = 0; j < n; ++j) {
    mark[j] = j;
    const auto take = [&](int i) {
      if (i > j && mark[i] != j) {
        mark[i] = j;
        structure[j].push_back(i);
      }
    };
    for (int i : below[j]) take(i);
    for (int c : children[j])
      for (int i : structure[c]) take(i);
    std::sort(structure[j].begin(), structure[j].end());
  }
  return structure;
}

/// Entries (3 × 3 blocks) that a front of p columns and r rows below keeps.
double entries(double p, double r) { return 0.5 * p * (p + 1) + p * r; }

/// Merge a child of `child` columns, `zeros` blocks of explicit zeros, into fronts of `columns` in
/// all and `total` blocks?
bool worth_merging(double columns, double zeros, double total) {
  for (const MultifrontalTuning::Merge& rule : kMultifrontal.merge)
    if (columns <= rule.columns) return zeros < rule.zeros * total;
  return false;
}

}  // namespace

double elimination_flops(double p, double r) { return p * p * p / 3 + p * p * r + p * r * r; }

double Front::flops() const {
  return elimination_flops(3.0 * columns, 3.0 * static_cast<double>(rows.size()));
}

FrontTree build_front_tree(const std::vector<int>& column_start, const std::vector<int>& rows,
                           const std::vector<int>& order) {
  const int n = static_cast<int>(order.size());
  FrontTree tree;
  tree.order = order;
  const auto invert = [&] {
    tree.number.resize(n);
    for (int k = 0; k < n; ++k) tree.number[tree.order[k]] = k;
  };
  invert();
  std::vector<int> parent = elimination_tree(permuted(column_start, rows, tree.number));
  {
    const std::vector<int> post = postorder(parent);
    std::vector<int> composed(n);
    for (int k = 0; k < n; ++k) composed[k] = tree.order[post[k]];
    tree.order = std::move(composed);
    invert();
  }
  const Lists below = permuted(column_start, rows, tree.number);
  parent = elimination_tree(below);
  const Lists structure = factor_structure(below, parent);

  // Fundamental fronts: runs of columns of which each has exactly the structure of the next.
  std::vector<int> first;  // column of each front, ascending
  std::vector<int> children(n, 0);
  for (int j = 0; j < n; ++j)
    if (parent[j] >= 0) ++children[parent[j]];
  for (int j = 0; j < n; ++j) {
    const bool joins = j > 0 && parent[j - 1] == j && children[j] == 1 &&
                       structure[j - 1].size() == structure[j].size() + 1;
    if (!joins) first.push_back(j);
  }
  // Merge a front into the one right behind it when that is its parent and few zeros are added.
  struct Run {
    int first, columns, below;
    double zeros;
  };
  std::vector<Run> runs;
  for (std::size_t f = 0; f < first.size(); ++f) {
    const int end = f + 1 < first.size() ? first[f + 1] : n;
    Run run{first[f], end - first[f], static_cast<int>(structure[end - 1].size()), 0};
    while (!runs.empty()) {
      const Run& child = runs.back();
      const int last = child.first + child.columns - 1;
      if (parent[last] < run.first || parent[last] >= run.first + run.columns) break;
      const int columns = child.columns + run.columns;
      const double total = entries(columns, run.below);
      const double kept = entries(child.columns, child.below) - child.zeros +
                          entries(run.columns, run.below) - run.zeros;
      if (!worth_merging(columns, total - kept, total)) break;
      run = {child.first, columns, run.below, total - kept};
      runs.pop_back();
    }
    runs.push_back(run);
  }

  tree.front_of.resize(n);
  for (const Run& run : runs) {
    Front front;
    front.first = run.first;
    front.columns = run.columns;
    front.rows = structure[run.first + run.columns - 1];
    for (int k = 0; k < run.columns; ++k)
      tree.front_of[run.first + k] = static_cast<int>(tree.fronts.size());
    tree.fronts.push_back(std::move(front));
  }
  for (std::size_t f = 0; f < tree.fronts.size(); ++f) {
    Front& front = tree.fronts[f];
    tree.flops += front.flops();
    if (front.rows.empty()) continue;
    front.parent = tree.front_of[front.rows.front()];
    Front& above = tree.fronts[front.parent];
    above.children.push_back(static_cast<int>(f));
    front.place.reserve(front.rows.size());
    std::size_t k = 0;
    for (int row : front.rows) {
      if (row < above.first + above.columns) {
        front.place.push_back(row - above.first);
        continue;
      }
      while (above.rows[k] < row) ++k;
      front.place.push_back(above.columns + static_cast<int>(k));
    }
  }
  return tree;
}

}  // namespace loosefit::solver

#include "loosefit/solver/linear/multifrontal/front_tree.h"

#include <algorithm>
#include <span>

#include "loosefit/base/check.h"
#include "loosefit/solver/linear/linear_tuning.h"

namespace loosefit::solver {
namespace {

/// A list of numbers for each of n columns, one after the other.
struct IndexLists {
  std::vector<int> start, entries;

  /// Of the pairs (list, entry) that `visit` hands to a function, called twice: to count, to fill.
  template <class Visit>
  IndexLists(int n, const Visit& visit) : start(n + 1, 0) {
    visit([&](int list, int) { ++start[list + 1]; });
    for (int i = 0; i < n; ++i) start[i + 1] += start[i];
    entries.resize(start[n]);
    std::vector<int> next(start.begin(), start.end() - 1);
    visit([&](int list, int entry) { entries[next[list]++] = entry; });
  }
  std::span<const int> operator[](int list) const {
    return {entries.data() + start[list], entries.data() + start[list + 1]};
  }
};

/// Hands over (row, column), row > column, for every entry of the permuted graph beside the
/// diagonal.
template <class Take>
void for_each_permuted_entry(const std::vector<int>& column_start, const std::vector<int>& rows,
                             const std::vector<int>& number, const Take& take) {
  const int n = static_cast<int>(number.size());
  for (int j = 0; j < n; ++j)
    for (int k = column_start[j]; k < column_start[j + 1]; ++k)
      if (rows[k] != j) {
        const auto [column, row] = std::minmax(number[j], number[rows[k]]);
        take(row, column);
      }
}

/// Parent of each column in the elimination tree (Liu 1990), from the columns < row of each row.
std::vector<int> elimination_tree(int n, const IndexLists& left) {
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

IndexLists children_of(const std::vector<int>& parent) {
  const int n = static_cast<int>(parent.size());
  return {n, [&](const auto& add) {
            for (int j = 0; j < n; ++j)
              if (parent[j] >= 0) add(parent[j], j);
          }};
}

/// Columns, children before parents; the i-th of them has the number i from then on.
std::vector<int> postorder(const std::vector<int>& parent, const IndexLists& children) {
  const int n = static_cast<int>(parent.size());
  std::vector<int> order, stack, next(n, 0);
  order.reserve(n);
  for (int root = 0; root < n; ++root) {
    if (parent[root] >= 0) continue;
    stack.push_back(root);
    while (!stack.empty()) {
      const int j = stack.back();
      if (next[j] < static_cast<int>(children[j].size())) {
        stack.push_back(children[j][next[j]++]);
      } else {
        order.push_back(j);
        stack.pop_back();
      }
    }
  }
  return order;
}

/// Rows below the diagonal of the factor. A column whose structure is that of the one before it,
/// its only child, without its own row shares the list.
struct FactorStructure {
  std::vector<int> entries;
  std::vector<std::size_t> begin, end;  ///< of each column
  std::vector<char> joins;              ///< the column before it

  std::span<const int> operator[](int column) const {
    return {entries.data() + begin[column], entries.data() + end[column]};
  }
  int size(int column) const { return static_cast<int>(end[column] - begin[column]); }
};

FactorStructure factor_structure(const IndexLists& below, const std::vector<int>& parent) {
  const int n = static_cast<int>(parent.size());
  const IndexLists children = children_of(parent);
  FactorStructure structure;
  structure.begin.resize(n);
  structure.end.resize(n);
  structure.joins.assign(n, 0);
  std::vector<int>& entries = structure.entries;
  std::vector<int> mark(n, -1);
  int head = -1;  // column that the list in work was made for; its rows are marked with it
  for (int j = 0; j < n; ++j) {
    const auto is_marked = [&](int i) { return mark[i] == head; };
    if (j > 0 && parent[j - 1] == j && children[j].size() == 1 &&
        std::all_of(below[j].begin(), below[j].end(), is_marked)) {
      structure.joins[j] = 1;
      structure.begin[j] = structure.begin[j - 1] + 1;  // j is the first of the list
      structure.end[j] = structure.end[j - 1];
      continue;
    }
    head = j;
    structure.begin[j] = entries.size();
    const auto take = [&](int i) {
      if (mark[i] == j) return;
      mark[i] = j;
      entries.push_back(i);
    };
    for (int i : below[j]) take(i);
    mark[j] = j;  // the first row of its children, not one of its own
    for (int c : children[j])
      for (std::size_t k = structure.begin[c]; k < structure.end[c]; ++k) take(entries[k]);
    structure.end[j] = entries.size();
    std::sort(entries.begin() + static_cast<long>(structure.begin[j]), entries.end());
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
  std::vector<int> parent(n);
  {
    const std::vector<int> tree_of_order =
        elimination_tree(n, {n, [&](const auto& add) {
                               for_each_permuted_entry(column_start, rows, tree.number, add);
                             }});
    const std::vector<int> post = postorder(tree_of_order, children_of(tree_of_order));
    // Renumbering by a postorder leaves the elimination tree as it is (Liu 1990).
    std::vector<int> composed(n), renumbered(n);
    for (int k = 0; k < n; ++k) {
      composed[k] = tree.order[post[k]];
      renumbered[post[k]] = k;
    }
    for (int k = 0; k < n; ++k) {
      const int above = tree_of_order[post[k]];
      parent[k] = above < 0 ? -1 : renumbered[above];
    }
    tree.order = std::move(composed);
    invert();
  }
  const IndexLists below(n, [&](const auto& add) {
    for_each_permuted_entry(column_start, rows, tree.number,
                            [&](int row, int column) { add(column, row); });
  });
  const FactorStructure structure = factor_structure(below, parent);

  // Fundamental fronts: runs of columns of which each has exactly the structure of the next.
  std::vector<int> first;  // column of each front, ascending
  for (int j = 0; j < n; ++j)
    if (!structure.joins[j]) first.push_back(j);
  // Merge a front into the one right behind it when that is its parent and few zeros are added.
  struct Run {
    int first, columns, below;
    double zeros;
  };
  std::vector<Run> runs;
  for (std::size_t f = 0; f < first.size(); ++f) {
    const int end = f + 1 < first.size() ? first[f + 1] : n;
    Run run{first[f], end - first[f], structure.size(end - 1), 0};
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
    const std::span<const int> border = structure[run.first + run.columns - 1];
    front.rows.assign(border.begin(), border.end());
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
      while (above.rows[k] < row) ++k;  // its rows are among those of the parent
      LOOSEFIT_ASSERT(above.rows[k] == row);
      front.place.push_back(above.columns + static_cast<int>(k));
    }
  }
  return tree;
}

}  // namespace loosefit::solver

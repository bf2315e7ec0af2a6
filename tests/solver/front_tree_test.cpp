#include "loosefit/solver/linear/multifrontal/front_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

namespace loosefit::solver {
namespace {

/// Lower triangle, diagonal included, of a symmetric graph.
struct Graph {
  std::vector<int> column_start{0}, rows;
};

/// `parts` graphs that nothing connects, of n vertices each: a path, and edges drawn beside it.
Graph drawn_graph(int parts, int n, int edges, unsigned seed) {
  std::mt19937 draw(seed);
  std::vector<std::vector<int>> columns(std::size_t(parts) * n);
  for (int part = 0; part < parts; ++part) {
    for (int j = 0; j < n; ++j) {
      std::vector<int>& column = columns[std::size_t(part) * n + j];
      column.push_back(part * n + j);
      if (j + 1 < n) column.push_back(part * n + j + 1);
    }
    for (int e = 0; e < edges; ++e) {
      const auto [a, b] = std::minmax({int(draw() % n), int(draw() % n)});
      columns[std::size_t(part) * n + a].push_back(part * n + b);
    }
  }
  Graph graph;
  for (std::vector<int>& column : columns) {
    std::ranges::sort(column);
    column.erase(std::unique(column.begin(), column.end()), column.end());
    graph.rows.insert(graph.rows.end(), column.begin(), column.end());
    graph.column_start.push_back(int(graph.rows.size()));
  }
  return graph;
}

/// Rows below the diagonal of each column of the factor, by eliminating one column after the other.
std::vector<std::vector<int>> filled(const Graph& graph, const std::vector<int>& number) {
  const std::size_t n = number.size();
  std::vector<std::vector<char>> there(n, std::vector<char>(n, 0));
  for (std::size_t j = 0; j < n; ++j)
    for (int k = graph.column_start[j]; k < graph.column_start[j + 1]; ++k) {
      const auto [low, high] = std::minmax(number[j], number[std::size_t(graph.rows[k])]);
      there[low][high] = 1;
    }
  std::vector<std::vector<int>> rows(n);
  for (std::size_t j = 0; j < n; ++j) {
    for (std::size_t i = j + 1; i < n; ++i)
      if (there[j][i]) rows[j].push_back(int(i));
    for (const int a : rows[j])
      for (const int b : rows[j])
        if (a < b) there[a][b] = 1;
  }
  return rows;
}

class DrawnGraph : public testing::TestWithParam<unsigned> {
 protected:
  void SetUp() override {
    const int parts = 1 + int(GetParam() % 3), n = 20;
    graph_ = drawn_graph(parts, n, 15, GetParam());
    std::vector<int> order(std::size_t(parts) * n);
    std::iota(order.begin(), order.end(), 0);
    std::shuffle(order.begin(), order.end(), std::mt19937(GetParam() + 100));
    tree_ = build_front_tree(graph_.column_start, graph_.rows, order);
    filled_ = filled(graph_, tree_.number);
  }
  int last_column(const Front& front) const { return front.first + front.columns - 1; }

  Graph graph_;
  FrontTree tree_;
  std::vector<std::vector<int>> filled_;
};

TEST_P(DrawnGraph, FrontsAreRunsOfAllColumnsWithChildrenBeforeParents) {
  int next = 0;
  for (std::size_t f = 0; f < tree_.fronts.size(); ++f) {
    const Front& front = tree_.fronts[f];
    EXPECT_EQ(front.first, next);
    next += front.columns;
    for (int j = front.first; j < next; ++j) {
      EXPECT_EQ(tree_.front_of[j], int(f));
      EXPECT_EQ(tree_.number[tree_.order[j]], j);
    }
    for (const int child : front.children) EXPECT_LT(child, int(f));
    EXPECT_EQ(front.parent < 0, front.rows.empty());
  }
  EXPECT_EQ(next, int(tree_.order.size()));
}

TEST_P(DrawnGraph, BordersAreTheFillAndHoldThatOfEveryColumnOfTheFront) {
  for (const Front& front : tree_.fronts) {
    EXPECT_EQ(front.rows, filled_[last_column(front)]);
    for (int j = front.first; j <= last_column(front); ++j)
      for (const int row : filled_[j])
        EXPECT_TRUE(row <= last_column(front) || std::ranges::binary_search(front.rows, row))
            << "column " << j << ", row " << row;
  }
}

// The only child of the next column that has just its rows and its own is never a front's last.
TEST_P(DrawnGraph, ColumnsOfOneStructureShareAFront) {
  for (std::size_t j = 1; j < filled_.size(); ++j) {
    std::vector<int> with_own = filled_[j];
    with_own.insert(with_own.begin(), int(j));
    const auto is_child = [&](const std::vector<int>& rows) {
      return !rows.empty() && rows.front() == int(j);
    };
    if (std::ranges::count_if(filled_, is_child) == 1 && filled_[j - 1] == with_own) {
      EXPECT_EQ(tree_.front_of[j - 1], tree_.front_of[j]) << "columns " << j - 1 << ", " << j;
    }
  }
}

TEST_P(DrawnGraph, PlacesOfABorderAreThoseOfItsRowsInTheParent) {
  for (const Front& front : tree_.fronts) {
    if (front.parent < 0) continue;
    const Front& parent = tree_.fronts[front.parent];
    ASSERT_EQ(front.place.size(), front.rows.size());
    for (std::size_t k = 0; k < front.rows.size(); ++k) {
      const int place = front.place[k];
      ASSERT_LT(place, parent.size());
      EXPECT_EQ(place < parent.columns ? parent.first + place : parent.rows[place - parent.columns],
                front.rows[k]);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, DrawnGraph, testing::Range(0u, 12u));

}  // namespace
}  // namespace loosefit::solver

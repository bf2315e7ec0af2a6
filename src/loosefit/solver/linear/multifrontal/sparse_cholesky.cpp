#include "loosefit/solver/linear/multifrontal/sparse_cholesky.h"

#include <tbb/task_group.h>

#include <algorithm>
#include <atomic>
#include <memory>
#include <new>

#include "loosefit/base/check.h"
#include "loosefit/base/error.h"
#include "loosefit/solver/linear/fill_order.h"
#include "loosefit/solver/linear/linear_tuning.h"
#include "loosefit/solver/linear/multifrontal/buffer_pool.h"
#include "loosefit/solver/linear/multifrontal/choose_kernels.h"
#include "loosefit/solver/linear/multifrontal/dense_kernels.h"
#include "loosefit/solver/linear/multifrontal/eliminate_front.h"
#include "loosefit/solver/linear/multifrontal/front_tree.h"

namespace loosefit::solver {
namespace {

/// Zeros wherever a front of p columns and r rows below is read: the lower triangle of the first
/// `columns` columns, and of its diagonal what comes along in whole blocks.
template <class Real>
void clear_lower(Real* a, int columns, int height, int p, int r) {
  const int block = diagonal_block(p, r);
  for (int c = 0; c < columns; ++c) {
    const int particle = c / 3 * 3, read_from = std::min(particle, c / block * block);
    Real* column = a + std::size_t(c) * height;
    std::fill(column + read_from, column + height, Real(0));
  }
}

}  // namespace

template <class Real>
struct SparseCholesky<Real>::Work {
  using Border = typename BufferPool<Real>::Buffer;

  FrontTree tree;
  std::vector<int> given_order;         ///< empty: to be found
  double flops_of_order = 0;            ///< when the order was chosen
  std::vector<int> column_start, rows;  ///< block pattern that the tree was made for
  std::vector<double> subtree_flops;
  /// Where a block of A goes.
  struct Entry {
    int block;  ///< of A, which couples the particles i (row) and j (column)
    int i, j;
    int row, column;  ///< place in the front, in blocks
    bool transposed;
  };
  std::vector<Entry> entries;                   ///< front by front
  std::vector<std::size_t> entry_start;         ///< of each front, and the end
  std::vector<std::unique_ptr<Real[]>> factor;  ///< per front: 3(p+r) × 3p, column major
  BufferPool<Real> pool;
  std::vector<Border> border;  ///< per front until its parent has taken it: 3r × 3r
  std::atomic<bool> definite{true};
  const particles::BlockMatrix* a = nullptr;
  const std::vector<double>* shift = nullptr;
  const std::vector<char>* held = nullptr;

  void analyse(const particles::BlockMatrix& matrix);
  void forget();
  void eliminate_subtree(int front);
  void eliminate(int front);
  void add_entries(int front, Real* f);
  void add_child(int child, Real* f, Border& border_of_parent);
};

template <class Real>
void SparseCholesky<Real>::Work::analyse(const particles::BlockMatrix& matrix) {
  column_start = matrix.column_start();
  rows = matrix.rows();
  // A few blocks more or less leave the old order good, most of the time.
  const auto n = static_cast<std::size_t>(matrix.particles());
  const bool given = given_order.size() == n, keep = given || tree.order.size() == n;
  if (keep)
    tree = build_front_tree(column_start, rows, std::vector<int>(given ? given_order : tree.order));
  if (!keep || (!given && tree.flops > kMultifrontal.reorder_growth * flops_of_order)) {
    tree = build_front_tree(column_start, rows, fill_reducing_order(column_start, rows));
    flops_of_order = tree.flops;
  }
  const std::size_t fronts = tree.fronts.size();
  subtree_flops.assign(fronts, 0);
  for (std::size_t f = 0; f < fronts; ++f) {
    const Front& front = tree.fronts[f];
    subtree_flops[f] += front.flops();
    if (front.parent >= 0) subtree_flops[front.parent] += subtree_flops[f];
  }
  const auto front_of_block = [&](int column, int k) {
    return tree.front_of[std::min(tree.number[column], tree.number[rows[k]])];
  };
  entry_start.assign(fronts + 1, 0);
  for (int j = 0; j < matrix.particles(); ++j)
    for (int k = column_start[j]; k < column_start[j + 1]; ++k)
      ++entry_start[front_of_block(j, k) + 1];
  for (std::size_t f = 0; f < fronts; ++f) entry_start[f + 1] += entry_start[f];
  entries.clear();  // before it grows: nothing of it is copied
  entries.resize(entry_start[fronts]);
  std::vector<std::size_t> next(entry_start.begin(), entry_start.end() - 1);
  for (int j = 0; j < matrix.particles(); ++j)
    for (int k = column_start[j]; k < column_start[j + 1]; ++k) {
      const int a_number = tree.number[j], b_number = tree.number[rows[k]];
      const auto [low, high] = std::minmax(a_number, b_number);
      const int f = front_of_block(j, k);
      const Front& front = tree.fronts[f];
      Entry e{k, rows[k], j, 0, low - front.first, b_number < a_number};
      if (high < front.first + front.columns)
        e.row = high - front.first;
      else {
        const auto at = std::lower_bound(front.rows.begin(), front.rows.end(), high);
        LOOSEFIT_ASSERT(at != front.rows.end() && *at == high);
        e.row = front.columns + static_cast<int>(at - front.rows.begin());
      }
      entries[next[f]++] = e;
    }
  factor.clear();
  factor.resize(fronts);
  border.clear();
  border.resize(fronts);
  pool.release();
}

/// Whatever was half made.
template <class Real>
void SparseCholesky<Real>::Work::forget() {
  tree = {};
  column_start.clear();
  factor.clear();
  border.clear();
  pool.release();
}

template <class Real>
void SparseCholesky<Real>::Work::add_entries(int front, Real* f) {
  const int height = 3 * tree.fronts[front].size();
  const bool any_held = !held->empty();
  for (std::size_t k = entry_start[front]; k < entry_start[front + 1]; ++k) {
    const Entry& e = entries[k];
    const Mat3& block = a->blocks()[e.block];
    Real* at = f + 3 * std::size_t(e.column) * height + 3 * e.row;
    if (any_held && ((*held)[e.i] || (*held)[e.j])) {
      if (e.i == e.j)
        for (int c = 0; c < 3; ++c) at[std::size_t(c) * height + c] += 1;
      continue;
    }
    for (int c = 0; c < 3; ++c)
      for (int r = 0; r < 3; ++r)
        at[std::size_t(c) * height + r] +=
            static_cast<Real>(e.transposed ? block(c, r) : block(r, c));
    if (e.i == e.j)
      for (int c = 0; c < 3; ++c)
        at[std::size_t(c) * height + c] += static_cast<Real>((*shift)[e.j]);
  }
}

template <class Real>
void SparseCholesky<Real>::Work::add_child(int child, Real* f, Border& border_of_parent) {
  const Front& from = tree.fronts[child];
  const Front& to = tree.fronts[from.parent];
  const int n = static_cast<int>(from.rows.size());
  const std::size_t height = 3 * std::size_t(to.size()), below = 3 * to.rows.size();
  const Real* source = border[child].get();
  for (int c = 0; c < n; ++c) {
    const int column = from.place[c];
    const bool eliminated = column < to.columns;
    Real* target = eliminated ? f + 3 * column * height
                              : border_of_parent.get() + 3 * (column - to.columns) * below;
    const std::size_t step = eliminated ? height : below;
    const int less = eliminated ? 0 : to.columns;
    // The three columns of a block at once: a third of the look-ups.
    const Real* s0 = source + 9 * std::size_t(c) * n;
    const Real *s1 = s0 + 3 * std::size_t(n), *s2 = s1 + 3 * std::size_t(n);
    for (int r = c; r < n; ++r) {
      Real* t0 = target + 3 * (from.place[r] - less);
      Real *t1 = t0 + step, *t2 = t1 + step;
      for (int k = 3 * r; k < 3 * r + 3; ++k) {
        *t0++ += s0[k];
        *t1++ += s1[k];
        *t2++ += s2[k];
      }
    }
  }
  border[child].reset();
}

template <class Real>
void SparseCholesky<Real>::Work::eliminate(int index) {
  const Front& front = tree.fronts[index];
  const int p = 3 * front.columns, r = 3 * static_cast<int>(front.rows.size()), height = p + r;
  if (!factor[index])
    factor[index] = std::make_unique_for_overwrite<Real[]>(std::size_t(height) * p);
  Real* f = factor[index].get();
  clear_lower(f, p, height, p, r);
  if (r > 0) {
    border[index] = pool.take(std::size_t(r) * r);
    clear_lower(border[index].get(), r, r, p, r);
  }
  add_entries(index, f);
  for (int child : front.children) add_child(child, f, border[index]);
  if (!eliminate_front(f, p, r, border[index].get())) definite = false;
}

template <class Real>
void SparseCholesky<Real>::Work::eliminate_subtree(int index) {
  const Front& front = tree.fronts[index];
  tbb::task_group group;
  bool parallel = false;
  for (std::size_t k = 0; k < front.children.size(); ++k) {
    const int child = front.children[k];
    if (subtree_flops[child] > kMultifrontal.task_flops && k + 1 < front.children.size()) {
      group.run([this, child] { eliminate_subtree(child); });
      parallel = true;
    } else {
      eliminate_subtree(child);
    }
  }
  // Where another branch ran out of memory, children may have been left out.
  if (parallel && group.wait() != tbb::task_group_status::complete) definite = false;
  if (definite) eliminate(index);
}

template <class Real>
SparseCholesky<Real>::SparseCholesky() : work_(std::make_unique<Work>()) {
  dense::choose_kernels();
}
template <class Real>
SparseCholesky<Real>::~SparseCholesky() = default;

template <class Real>
bool SparseCholesky<Real>::factorise(const particles::BlockMatrix& a,
                                     const std::vector<double>& shift,
                                     const std::vector<char>& held) try {
  Work& w = *work_;
  if (w.tree.order.empty() || w.column_start != a.column_start() || w.rows != a.rows())
    w.analyse(a);
  w.a = &a;
  w.shift = &shift;
  w.held = &held;
  w.definite = true;
  tbb::task_group roots;
  for (std::size_t f = 0; f < w.tree.fronts.size(); ++f)
    if (w.tree.fronts[f].parent < 0)
      roots.run([&w, f] { w.eliminate_subtree(static_cast<int>(f)); });
  roots.wait();
  if (!w.definite)
    for (auto& border : w.border) border.reset();
  return w.definite;
} catch (const std::bad_alloc&) {
  work_->forget();
  throw;
}

template <class Real>
void SparseCholesky<Real>::release() {
  for (auto& front : work_->factor) front.reset();
  work_->pool.release();
}

template <class Real>
const std::vector<int>& SparseCholesky<Real>::order() const {
  return work_->tree.order;
}

template <class Real>
void SparseCholesky<Real>::set_order(std::vector<int> order) {
  work_->given_order = std::move(order);
  work_->column_start.clear();
}

template <class Real>
void SparseCholesky<Real>::solve(const std::vector<Vec3>& rhs, std::vector<Vec3>& x) const {
  const Work& w = *work_;
  const int n = static_cast<int>(rhs.size());
  LOOSEFIT_ASSERT(w.definite && rhs.size() == w.tree.order.size() && !w.factor.empty() &&
                  w.factor.front());
  Eigen::Matrix<Real, Eigen::Dynamic, 1> y(3 * n), part;
  for (int k = 0; k < n; ++k)
    y.template segment<3>(3 * k) = rhs[w.tree.order[k]].template cast<Real>();
  for (std::size_t f = 0; f < w.tree.fronts.size(); ++f) {
    const Front& front = w.tree.fronts[f];
    const int p = 3 * front.columns, r = 3 * static_cast<int>(front.rows.size()), height = p + r;
    const Real* factor = w.factor[f].get();
    Real* pivot = y.data() + 3 * front.first;
    dense::solve_lower(factor, p, height, pivot);
    if (r == 0) continue;
    part.resize(r);
    dense::multiply(factor + p, r, p, height, pivot, part.data());
    for (std::size_t i = 0; i < front.rows.size(); ++i)
      y.template segment<3>(3 * front.rows[i]) -=
          part.template segment<3>(3 * static_cast<long>(i));
  }
  for (std::size_t f = w.tree.fronts.size(); f-- > 0;) {
    const Front& front = w.tree.fronts[f];
    const int p = 3 * front.columns, r = 3 * static_cast<int>(front.rows.size()), height = p + r;
    const Real* factor = w.factor[f].get();
    Real* pivot = y.data() + 3 * front.first;
    if (r > 0) {
      part.resize(r);
      for (std::size_t i = 0; i < front.rows.size(); ++i)
        part.template segment<3>(3 * static_cast<long>(i)) =
            y.template segment<3>(3 * front.rows[i]);
      dense::subtract_transposed(factor + p, r, p, height, part.data(), pivot);
    }
    dense::solve_lower_transposed(factor, p, height, pivot);
  }
  x.resize(n);
  for (int k = 0; k < n; ++k)
    x[w.tree.order[k]] = y.template segment<3>(3 * k).template cast<double>();
}

template class SparseCholesky<float>;
template class SparseCholesky<double>;

}  // namespace loosefit::solver

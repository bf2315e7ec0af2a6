#include "loosefit/solver/linear/multifrontal/eliminate_front.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstddef>

#include "loosefit/solver/linear/linear_tuning.h"
#include "loosefit/solver/linear/multifrontal/dense_kernels.h"
#include "loosefit/solver/linear/multifrontal/front_tree.h"

namespace loosefit::solver {
namespace {

constexpr int kBlock = kMultifrontal.front_block;

bool is_large(int p, int r) { return elimination_flops(p, r) > kMultifrontal.large_front_flops; }

template <class Work>
void for_blocks(int first, int end, const Work& work) {
  const int blocks = (end - first + kBlock - 1) / kBlock;
  tbb::parallel_for(0, blocks, [&](int k) {
    const int from = first + k * kBlock;
    work(from, std::min(kBlock, end - from));
  });
}

template <class Real>
bool eliminate_large(Real* f, int p, int r, Real* border) {
  const int height = p + r;
  const auto at = [&](int row, int column) { return f + std::size_t(column) * height + row; };
  for (int k = 0; k < p; k += kBlock) {
    const int width = std::min(kBlock, p - k), next = k + width;
    if (!dense::factorise(at(k, k), width, height)) return false;
    for_blocks(next, height, [&](int row, int rows) {
      dense::divide_rows(at(k, k), width, at(row, k), rows, height);
    });
    for_blocks(next, p, [&](int column, int columns) {
      dense::subtract_product(at(column, k), height - column, at(column, k), columns, width, height,
                              at(column, column), height);
    });
  }
  for_blocks(0, r, [&](int column, int columns) {
    dense::subtract_product(at(p + column, 0), r - column, at(p + column, 0), columns, p, height,
                            border + std::size_t(column) * r + column, r);
  });
  return true;
}

}  // namespace

int diagonal_block(int p, int r) { return is_large(p, r) ? kBlock : 1; }

template <class Real>
bool eliminate_front(Real* f, int p, int r, Real* border) {
  if (is_large(p, r)) return eliminate_large(f, p, r, border);
  if (!dense::factorise(f, p, p + r)) return false;
  if (r == 0) return true;
  dense::divide_rows(f, p, f + p, r, p + r);
  dense::subtract_square(f + p, r, p, p + r, border);
  return true;
}

template bool eliminate_front(float*, int, int, float*);
template bool eliminate_front(double*, int, int, double*);

}  // namespace loosefit::solver

#include "loosefit/solver/linear/cholmod_solver.h"

#include <cholmod.h>

#include <new>
#include <utility>

#include "loosefit/base/check.h"
#include "loosefit/base/error.h"
#include "loosefit/solver/linear/fill_order.h"

namespace loosefit::solver {
namespace {

constexpr int kSize = 3;  ///< rows of a block

}  // namespace

struct CholmodSolver::Work {
  cholmod_common common;
  cholmod_sparse* matrix = nullptr;  ///< lower triangle, scalar columns
  cholmod_factor* factor = nullptr;
  std::vector<int> column_start, rows;  ///< block pattern that `matrix` was made for
  std::vector<int> order;
  /// Kept between calls of `solve`, as CHOLMOD asks for.
  cholmod_dense *result = nullptr, *scratch_y = nullptr, *scratch_e = nullptr;

  Work() {
    cholmod_start(&common);
    common.print = 0;
    common.error_handler = nullptr;
    common.supernodal = CHOLMOD_SUPERNODAL;
    common.nmethods = 1;
    common.method[0].ordering = CHOLMOD_GIVEN;
    common.postorder = 1;
  }
  ~Work() {
    free_factor();
    cholmod_free_sparse(&matrix, &common);
    cholmod_free_dense(&result, &common);
    cholmod_free_dense(&scratch_y, &common);
    cholmod_free_dense(&scratch_e, &common);
    cholmod_finish(&common);
  }
  Work(const Work&) = delete;
  Work& operator=(const Work&) = delete;

  void free_factor() { cholmod_free_factor(&factor, &common); }
  void check_memory() const {
    if (common.status == CHOLMOD_OUT_OF_MEMORY) throw std::bad_alloc();
    if (common.status == CHOLMOD_TOO_LARGE)
      throw SolverFailure("the matrix of the Newton step is too large: use longer edges");
  }

  void analyse(const particles::BlockMatrix& a);
  void fill(const particles::BlockMatrix& a, const std::vector<double>& shift,
            const std::vector<char>& held);
};

/// Scalar pattern of the lower triangle, and the symbolic factorisation in the block order.
void CholmodSolver::Work::analyse(const particles::BlockMatrix& a) {
  free_factor();
  cholmod_free_sparse(&matrix, &common);
  column_start = a.column_start();
  rows = a.rows();
  const int n = a.particles();
  std::size_t entries = 0;
  for (int j = 0; j < n; ++j)  // full blocks below the diagonal, half of the one on it
    entries += std::size_t(kSize) * kSize * (column_start[j + 1] - column_start[j]) - kSize;
  matrix = cholmod_allocate_sparse(std::size_t(kSize) * n, std::size_t(kSize) * n, entries, 1, 1,
                                   -1, CHOLMOD_REAL, &common);
  check_memory();
  auto* start = static_cast<int*>(matrix->p);
  auto* row = static_cast<int*>(matrix->i);
  int next = 0;
  for (int j = 0; j < n; ++j)
    for (int c = 0; c < kSize; ++c) {
      start[kSize * j + c] = next;
      for (int k = column_start[j]; k < column_start[j + 1]; ++k)
        for (int r = rows[k] == j ? c : 0; r < kSize; ++r) row[next++] = kSize * rows[k] + r;
    }
  start[kSize * n] = next;

  if (static_cast<int>(order.size()) != n) order = fill_reducing_order(column_start, rows);
  std::vector<int> scalar_order;
  for (const int particle : order)
    for (int c = 0; c < kSize; ++c) scalar_order.push_back(kSize * particle + c);
  factor = cholmod_analyze_p(matrix, scalar_order.data(), nullptr, 0, &common);
  check_memory();
  if (!factor) throw SolverFailure("CHOLMOD cannot analyse the matrix of the Newton step");
}

void CholmodSolver::Work::fill(const particles::BlockMatrix& a, const std::vector<double>& shift,
                               const std::vector<char>& held) {
  auto* value = static_cast<double*>(matrix->x);
  const auto is_held = [&](int i) { return !held.empty() && held[i]; };
  for (int j = 0; j < a.particles(); ++j)
    for (int c = 0; c < kSize; ++c)
      for (int k = column_start[j]; k < column_start[j + 1]; ++k) {
        const int i = rows[k];
        const bool identity = is_held(i) || is_held(j);
        for (int r = i == j ? c : 0; r < kSize; ++r) {
          const bool diagonal = i == j && r == c;
          *value++ =
              identity ? (diagonal ? 1.0 : 0.0) : a.blocks()[k](r, c) + (diagonal ? shift[j] : 0.0);
        }
      }
}

CholmodSolver::CholmodSolver() : work_(std::make_unique<Work>()) {}
CholmodSolver::~CholmodSolver() = default;

bool CholmodSolver::factorise(const particles::BlockMatrix& a, const std::vector<double>& shift,
                              const std::vector<char>& held) {
  Work& w = *work_;
  if (!w.factor || a.column_start() != w.column_start || a.rows() != w.rows) w.analyse(a);
  w.fill(a, shift, held);
  w.common.quick_return_if_not_posdef = 1;
  cholmod_factorize(w.matrix, w.factor, &w.common);
  w.check_memory();
  return w.common.status == CHOLMOD_OK && w.factor->minor == w.factor->n;
}

void CholmodSolver::solve(const std::vector<Vec3>& rhs, std::vector<Vec3>& x) const {
  Work& w = *work_;
  LOOSEFIT_ASSERT(w.factor && w.factor->minor == w.factor->n && w.factor->n == kSize * rhs.size());
  // A view of the right-hand side: CHOLMOD only reads it.
  cholmod_dense b = {};
  b.nrow = b.nzmax = b.d = kSize * rhs.size();
  b.ncol = 1;
  b.x = const_cast<double*>(rhs.front().data());
  b.xtype = CHOLMOD_REAL;
  b.dtype = CHOLMOD_DOUBLE;
  cholmod_solve2(CHOLMOD_A, w.factor, &b, nullptr, &w.result, nullptr, &w.scratch_y, &w.scratch_e,
                 &w.common);
  w.check_memory();
  const auto* value = static_cast<const double*>(w.result->x);
  x.resize(rhs.size());
  for (std::size_t i = 0; i < x.size(); ++i)
    x[i] = Vec3(value[kSize * i], value[kSize * i + 1], value[kSize * i + 2]);
}

void CholmodSolver::release() {
  // Back to what the symbolic analysis left.
  if (work_->factor)
    cholmod_change_factor(CHOLMOD_PATTERN, 1, 1, 1, 1, work_->factor, &work_->common);
}

const std::vector<int>& CholmodSolver::order() const { return work_->order; }

void CholmodSolver::set_order(std::vector<int> order) {
  work_->order = std::move(order);
  work_->free_factor();
}

}  // namespace loosefit::solver

#include "loosefit/solver/sparse_cholesky.h"

#include <cholmod.h>

#include <mutex>

#include "loosefit/base/error.h"

/// From the OpenMP run-time that CHOLMOD brings along; its header needs a compiler flag we do not
/// set.
extern "C" void omp_set_max_active_levels(int levels);

namespace loosefit {

struct SparseCholesky::Work {
  cholmod_common common;
  cholmod_sparse* matrix = nullptr;
  cholmod_factor* factor = nullptr;
  std::vector<int> order;               ///< of the scalar unknowns
  std::vector<int> column_start, rows;  ///< block pattern that `matrix` was made for

  Work() {
    // CHOLMOD opens four OpenMP threads whatever the machine; on two cores their waiting costs more
    // than the whole factorisation.
    omp_set_max_active_levels(0);
    cholmod_start(&common);
    common.supernodal = CHOLMOD_SUPERNODAL;
    common.final_ll = 1;
    common.print = 0;
    common.error_handler = nullptr;
  }
  ~Work() {
    if (factor) cholmod_free_factor(&factor, &common);
    if (matrix) cholmod_free_sparse(&matrix, &common);
    cholmod_finish(&common);
  }

  void find_order(const BlockMatrix& a);
  void analyse(const BlockMatrix& a);
  void fill(const BlockMatrix& a, const std::vector<double>& shift, const std::vector<char>& held);
};

void SparseCholesky::Work::find_order(const BlockMatrix& a) {
  const int n = a.particles();
  // Graph of the blocks; values are not needed to find an order.
  // METIS draws from the one random sequence of the C library: two at a time would share it.
  static std::mutex one_at_a_time;
  const std::lock_guard lock(one_at_a_time);
  cholmod_sparse* graph =
      cholmod_allocate_sparse(n, n, a.rows().size(), 1, 1, -1, CHOLMOD_PATTERN, &common);
  if (!graph) throw SolverFailure("out of memory in the sparse factorisation");
  std::copy(a.column_start().begin(), a.column_start().end(), static_cast<int*>(graph->p));
  std::copy(a.rows().begin(), a.rows().end(), static_cast<int*>(graph->i));
  const int methods = common.nmethods;
  const auto ordering = common.method[0].ordering;
  common.nmethods = 1;
  common.method[0].ordering = n > 500 ? CHOLMOD_METIS : CHOLMOD_AMD;
  cholmod_factor* symbolic = cholmod_analyze(graph, &common);
  common.nmethods = methods;
  common.method[0].ordering = ordering;
  cholmod_free_sparse(&graph, &common);
  if (!symbolic) throw SolverFailure("out of memory in the sparse factorisation");
  order.resize(3 * n);
  for (int k = 0; k < n; ++k)
    for (int c = 0; c < 3; ++c) order[3 * k + c] = 3 * static_cast<int*>(symbolic->Perm)[k] + c;
  cholmod_free_factor(&symbolic, &common);
}

void SparseCholesky::Work::analyse(const BlockMatrix& a) {
  if (static_cast<int>(order.size()) != 3 * a.particles()) find_order(a);
  if (factor) cholmod_free_factor(&factor, &common);
  if (matrix) cholmod_free_sparse(&matrix, &common);
  column_start = a.column_start();
  rows = a.rows();
  const int n = a.particles();
  const std::size_t entries = rows.size() * 9 - std::size_t(n) * 3;
  matrix = cholmod_allocate_sparse(3 * n, 3 * n, entries, 1, 1, -1, CHOLMOD_REAL, &common);
  if (!matrix) throw SolverFailure("out of memory in the sparse factorisation");
  int* p = static_cast<int*>(matrix->p);
  int* i = static_cast<int*>(matrix->i);
  int at = 0;
  for (int j = 0; j < n; ++j)
    for (int c = 0; c < 3; ++c) {
      p[3 * j + c] = at;
      for (int k = column_start[j]; k < column_start[j + 1]; ++k)
        for (int r = rows[k] == j ? c : 0; r < 3; ++r) i[at++] = 3 * rows[k] + r;
    }
  p[3 * n] = at;
  const int methods = common.nmethods;
  const auto ordering = common.method[0].ordering;
  common.nmethods = 1;
  common.method[0].ordering = CHOLMOD_GIVEN;
  factor = cholmod_analyze_p(matrix, order.data(), nullptr, 0, &common);
  common.nmethods = methods;
  common.method[0].ordering = ordering;
  if (!factor) throw SolverFailure("out of memory in the sparse factorisation");
}

void SparseCholesky::Work::fill(const BlockMatrix& a, const std::vector<double>& shift,
                                const std::vector<char>& held) {
  double* value = static_cast<double*>(matrix->x);
  const bool any_held = !held.empty();
  int at = 0;
  for (int j = 0; j < a.particles(); ++j)
    for (int c = 0; c < 3; ++c)
      for (int k = column_start[j]; k < column_start[j + 1]; ++k) {
        const int row = rows[k];
        const bool off = any_held && (held[j] || held[row]);
        for (int r = row == j ? c : 0; r < 3; ++r) {
          double v = off ? 0.0 : a.blocks()[k](r, c);
          if (row == j && r == c) v = off ? 1.0 : v + shift[j];
          value[at++] = v;
        }
      }
}

SparseCholesky::SparseCholesky() : work_(std::make_unique<Work>()) {}
SparseCholesky::~SparseCholesky() = default;

bool SparseCholesky::factorise(const BlockMatrix& a, const std::vector<double>& shift,
                               const std::vector<char>& held) {
  Work& w = *work_;
  if (!w.factor || w.column_start != a.column_start() || w.rows != a.rows()) w.analyse(a);
  w.fill(a, shift, held);
  cholmod_factorize(w.matrix, w.factor, &w.common);
  if (w.common.status == CHOLMOD_OUT_OF_MEMORY)
    throw SolverFailure("out of memory in the sparse factorisation");
  return w.common.status == CHOLMOD_OK;
}

void SparseCholesky::solve(const std::vector<Vec3>& rhs, std::vector<Vec3>& x) {
  Work& w = *work_;
  const std::size_t n = rhs.size();
  cholmod_dense* b = cholmod_allocate_dense(3 * n, 1, 3 * n, CHOLMOD_REAL, &w.common);
  double* values = static_cast<double*>(b->x);
  for (std::size_t i = 0; i < n; ++i)
    for (int c = 0; c < 3; ++c) values[3 * i + c] = rhs[i][c];
  cholmod_dense* solution = cholmod_solve(CHOLMOD_A, w.factor, b, &w.common);
  x.resize(n);
  for (std::size_t i = 0; i < n; ++i)
    for (int c = 0; c < 3; ++c) x[i][c] = static_cast<double*>(solution->x)[3 * i + c];
  cholmod_free_dense(&b, &w.common);
  cholmod_free_dense(&solution, &w.common);
}

}  // namespace loosefit

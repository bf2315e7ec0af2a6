#include "loosefit/solver/linear/fill_order.h"

#include <cholmod.h>

#include <algorithm>
#include <mutex>
#include <new>

#include "loosefit/base/error.h"
#include "loosefit/solver/linear/linear_tuning.h"

namespace loosefit::solver {
namespace {

struct Common {
  cholmod_common c;
  Common() {
    cholmod_start(&c);
    c.print = 0;
    c.error_handler = nullptr;
    c.nmethods = 1;
  }
  ~Common() { cholmod_finish(&c); }
};

}  // namespace

std::vector<int> fill_reducing_order(const std::vector<int>& column_start,
                                     const std::vector<int>& rows) {
  const int n = static_cast<int>(column_start.size()) - 1;
  // METIS draws from the one random sequence of the C library: two at a time would share it.
  static std::mutex one_at_a_time;
  const std::lock_guard lock(one_at_a_time);
  Common common;
  common.c.method[0].ordering = n > kMultifrontal.small_graph ? CHOLMOD_METIS : CHOLMOD_AMD;
  cholmod_sparse* graph =
      cholmod_allocate_sparse(n, n, rows.size(), 1, 1, -1, CHOLMOD_PATTERN, &common.c);
  if (!graph) throw std::bad_alloc();
  std::copy(column_start.begin(), column_start.end(), static_cast<int*>(graph->p));
  std::copy(rows.begin(), rows.end(), static_cast<int*>(graph->i));
  cholmod_factor* symbolic = cholmod_analyze(graph, &common.c);
  cholmod_free_sparse(&graph, &common.c);
  if (!symbolic && common.c.status == CHOLMOD_OUT_OF_MEMORY) throw std::bad_alloc();
  if (!symbolic) throw SolverFailure("CHOLMOD cannot order the matrix of the Newton step");
  const int* perm = static_cast<const int*>(symbolic->Perm);
  std::vector<int> order(perm, perm + n);
  cholmod_free_factor(&symbolic, &common.c);
  return order;
}

}  // namespace loosefit::solver

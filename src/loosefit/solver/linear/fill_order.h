#pragma once
#include <vector>

namespace loosefit::solver {

/// Fill-reducing elimination order of a symmetric graph given as the rows ≥ column of each column
/// (compressed columns, diagonal included): nested dissection (METIS; Karypis and Kumar 1998) for
/// large graphs, minimum degree (AMD) for small ones, both through CHOLMOD. order[k] is the vertex
/// that is eliminated k-th.
/// \throws std::bad_alloc when memory runs out, SolverFailure.
std::vector<int> fill_reducing_order(const std::vector<int>& column_start,
                                     const std::vector<int>& rows);

}  // namespace loosefit::solver

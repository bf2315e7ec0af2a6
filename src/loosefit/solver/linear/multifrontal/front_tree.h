#pragma once
#include <vector>

namespace loosefit::solver {

/// One dense front of a multifrontal factorisation: consecutive columns that share their structure.
struct Front {
  int first = 0, columns = 0;  ///< eliminated here, in the new numbering
  std::vector<int> rows;       ///< below them, ascending: the border that is passed to the parent
  int parent = -1;
  std::vector<int> children;
  std::vector<int> place;  ///< of each row of the border among the parent's columns and rows
  int size() const { return columns + static_cast<int>(rows.size()); }
  double flops() const;  ///< of its elimination with 3 × 3 blocks
};

/// Floating point operations of eliminating p of p + r rows of a dense symmetric matrix.
double elimination_flops(double p, double r);

/// Symbolic factorisation of a symmetric graph: elimination order refined to a postorder of the
/// elimination tree, columns gathered into fronts; small fronts are merged into their parents where
/// that adds few zeros, since dense kernels are slow on narrow ones (Ashcraft and Grimes 1989).
struct FrontTree {
  std::vector<int> order;     ///< new number → vertex
  std::vector<int> number;    ///< vertex → new number
  std::vector<int> front_of;  ///< new number → front
  std::vector<Front> fronts;  ///< children before parents
  double flops = 0;           ///< of one numeric factorisation with 3 × 3 blocks
};

/// `rows`: rows ≥ column of each column, diagonal included; `order` from fill_reducing_order.
FrontTree build_front_tree(const std::vector<int>& column_start, const std::vector<int>& rows,
                           const std::vector<int>& order);

}  // namespace loosefit::solver

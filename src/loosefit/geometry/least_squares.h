#pragma once
#include "loosefit/base/types.h"

namespace loosefit::geometry {

/// The x for which matrix · x comes nearest to `right`; rows ≥ columns. QR with column pivots, so
/// that dependent columns give a small answer instead of none.
Eigen::VectorXd least_squares(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right);

}  // namespace loosefit::geometry

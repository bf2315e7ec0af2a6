#include "loosefit/geometry/least_squares.h"

#include <Eigen/QR>

namespace loosefit::geometry {

Eigen::VectorXd least_squares(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right) {
  return matrix.colPivHouseholderQr().solve(right);
}

}  // namespace loosefit::geometry

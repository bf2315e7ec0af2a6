#include "loosefit/geometry/principal_axes.h"

#include <Eigen/Eigenvalues>

namespace loosefit::geometry {

PrincipalAxes principal_axes(const Mat3& symmetric) {
  const Eigen::SelfAdjointEigenSolver<Mat3> solver(symmetric);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

}  // namespace loosefit::geometry

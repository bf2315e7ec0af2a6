#include "loosefit/geometry/nearest_rotation.h"

#include <Eigen/LU>
#include <Eigen/SVD>

namespace loosefit::geometry {

Mat3 nearest_rotation(const Mat3& matrix) {
  const Eigen::JacobiSVD<Mat3> svd(matrix, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Mat3 proper = Mat3::Identity();
  proper(2, 2) = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0 ? -1 : 1;
  return svd.matrixU() * proper * svd.matrixV().transpose();
}

}  // namespace loosefit::geometry

#pragma once
#include "loosefit/base/types.h"

namespace loosefit::geometry {

/// Eigenvalues of a symmetric matrix in rising order and unit eigenvectors, in its columns.
struct PrincipalAxes {
  Vec3 values;
  Mat3 axes;
};

PrincipalAxes principal_axes(const Mat3& symmetric);

}  // namespace loosefit::geometry

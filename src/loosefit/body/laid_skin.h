#pragma once
#include <Eigen/Core>
#include <vector>

#include "loosefit/geometry/triangle_mesh.h"

namespace loosefit::body {

/// The skin of a person of the model where it stands, and how each vertex came there from the rest
/// posture [m].
struct LaidSkin {
  std::vector<Vec3> rest, surface;
  std::vector<Eigen::Matrix<double, 3, 4>> maps;  ///< posed, but for PosedPerson::place
  std::vector<Triangle> triangles;
  std::vector<Vec3> joints;  ///< heads of the bones of BodyData
};

}  // namespace loosefit::body

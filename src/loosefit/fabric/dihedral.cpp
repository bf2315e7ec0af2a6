#include "loosefit/fabric/dihedral.h"

#include <Eigen/Geometry>
#include <cmath>

namespace loosefit::fabric {
double dihedral_angle(const Vec3& x0, const Vec3& x1, const Vec3& x2, const Vec3& x3) {
  const Vec3 e = x1 - x0;
  const Vec3 n1 = e.cross(x2 - x0), n2 = (x3 - x0).cross(e);
  return std::atan2(n1.cross(n2).dot(e / e.norm()), n1.dot(n2));
}

}  // namespace loosefit::fabric

#pragma once
#include <vector>

#include "loosefit/contact/contact_features.h"
#include "loosefit/geometry/triangle_mesh.h"

namespace loosefit::drape {

/// A displacement of the cloth on which nothing of it runs into itself: particles of features that
/// would meet on the straight way are joined to zones, each of which moves as the rigid motion that
/// fits its displacements best (rigid impact zones: Provot 1997; Bridson, Fedkiw and Anderson
/// 2002). After `rounds` without success what is left is returned as it is.
std::vector<Vec3> without_impacts(const contact::ContactFeatures& features,
                                  const std::vector<Vec3>& x, const std::vector<Vec3>& displacement,
                                  int rounds);

}  // namespace loosefit::drape

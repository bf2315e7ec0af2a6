#pragma once
#include <functional>

#include "loosefit/geometry/closest_point_tree.h"

namespace loosefit::body {

/// Skin that faces skin as near [m] is not seen by a scanner, and pressed: in armpits, between the
/// thighs, under hanging arms.
inline constexpr double kFacingSkin = 0.03;

/// Distance at which folds of skin begin to repel each other where flesh gives way (module flesh)
/// [m]; they come to rest at 6 to 7 mm. A field of distances of 5 mm must tell both skins of a
/// cleft apart, and two layers of cloth of 10 mm edges must lie there without cutting them
/// (docs/decisions/0011-soft-flesh.md).
inline constexpr double kSkinGap = 0.008;

/// Whether other skin of a surface faces a place p of it within kFacingSkin: ahead along its unit
/// normal n, with a normal more than about 120 degrees from n. normal_of: unit normal of a
/// triangle.
bool faces_skin(const geometry::ClosestPointTree& skin, const std::function<Vec3(int)>& normal_of,
                const Vec3& p, const Vec3& n);

}  // namespace loosefit::body

#pragma once
#include <memory>

#include "loosefit/body/body.h"
#include "loosefit/contact/distance_field.h"

namespace loosefit {

/// A body in one posture with what contact needs of it.
struct PosedBody {
  Body body;
  std::unique_ptr<ClosestPointTree> tree;
  std::shared_ptr<const DistanceField> field;
};

/// reach: box round the cloth; the field covers it with a margin for motion.
std::unique_ptr<PosedBody> pose_for_contact(Body body, const Box3& cloth, double spacing);

/// Motion of the skin nearest to each point when the body under it moves from one posture to the
/// next, the point taken along rigidly [m]; zero for bodies without a skeleton.
std::vector<Vec3> skin_motion(const PosedBody& from, const Body& to, const std::vector<Vec3>& x);

/// The same smoothed over some 40 mm of the cloth at x: where the cloth goes with the body.
std::vector<Vec3> smoothed_over(const std::vector<Triangle>& triangles, const std::vector<Vec3>& x,
                                std::vector<Vec3> motion);

/// Box round points.
Box3 bounds(const std::vector<Vec3>& x);

}  // namespace loosefit

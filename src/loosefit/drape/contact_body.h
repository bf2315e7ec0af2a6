#pragma once
#include <memory>

#include "loosefit/body/posed_body.h"
#include "loosefit/contact/distance_field.h"
#include "loosefit/contact/floor.h"
#include "loosefit/drape/settling_tuning.h"

namespace loosefit::drape {

/// A posed body with the distance field of its skin round the cloth, and the floor it stands on.
struct ContactBody {
  body::PosedBody body;
  std::shared_ptr<const contact::DistanceField> field;  ///< asks the tree of `body`
  std::shared_ptr<const contact::Floor> floor;          ///< body::floor_under; null: none
};

/// cloth: box round the cloth; the field covers it with a margin for motion, the larger one below.
/// arms_go_up: folds of armpits are filled as on the way up (cleft_cover.h).
std::shared_ptr<const ContactBody> with_field(body::PosedBody body, const geometry::Box3& cloth,
                                              double spacing, const CarryTuning& tuning = {},
                                              bool arms_go_up = false);

/// A rigid or nearly rigid motion: x → M x.
using MotionMap = Eigen::Matrix<double, 3, 4>;

/// Motion of the skin nearest to each point when the body under it moves from one posture to the
/// next; no motion for bodies without a skeleton.
std::vector<MotionMap> skin_motion(const body::PosedBody& from, const body::Body& to,
                                   const std::vector<Vec3>& x);

/// The same smoothed over CarryTuning::smoothing_length of the cloth at x: how the cloth goes with
/// the body. The maps are smoothed, not the ways, so that what moves as a whole keeps its shape.
std::vector<MotionMap> smoothed_over(const std::vector<Triangle>& triangles,
                                     const std::vector<Vec3>& x, std::vector<MotionMap> motion,
                                     const CarryTuning& tuning);

/// How far each point goes [m].
std::vector<Vec3> displacements(const std::vector<MotionMap>& motion, const std::vector<Vec3>& x);

/// Box round points.
geometry::Box3 bounds(const std::vector<Vec3>& x);

}  // namespace loosefit::drape

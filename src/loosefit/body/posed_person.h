#pragma once
#include "loosefit/body/body_parameters.h"
#include "loosefit/body/rigid_motion.h"
#include "loosefit/body/skeleton_pose.h"

namespace loosefit::body {

/// A person of the model in any pose, anywhere: shape, turns of bones, and the place of the whole.
struct PosedPerson {
  BodyParameters parameters;
  BoneRotations rotations;
  RigidMotion place = RigidMotion::Identity();  ///< the posed model → the world
};

}  // namespace loosefit::body

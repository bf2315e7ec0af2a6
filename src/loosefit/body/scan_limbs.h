#pragma once
#include <array>
#include <vector>

#include "loosefit/geometry/triangle_mesh.h"

namespace loosefit::body {

/// What of a standing body a vertex hangs on.
enum class ScanLimb : signed char { core, left_arm, right_arm, left_leg, right_leg };

/// A limb as a chain of loops, from where it leaves the trunk outwards.
struct LimbChain {
  struct Ring {
    Vec3 centre;
    double length = 0;  ///< round the limb [m]
    double reach = 0;   ///< way over the skin from the crown [m]
  };
  std::vector<Ring> rings;     ///< empty when the limb was not found
  Vec3 fold = Vec3::Zero();    ///< armpit, crotch
  Vec3 parted = Vec3::Zero();  ///< where the surface parts; of arms grown together with the trunk
                               ///< this lies below the fold
  Vec3 tip = Vec3::Zero();     ///< its farthest point
  bool touches = false;        ///< its end is grown together with something else
  bool found() const { return !rings.empty(); }
};

/// Arms and legs of a standing body, by topology: the loops of equal way over the skin from the
/// crown (the Reeb graph of that way) are one round head and trunk; they part at the armpits and
/// the crotch. So the posture of the arms does not matter, nor that surfaces touch or pass through
/// each other. Where a hand has grown together with a thigh, the way from the trunk along the arm
/// meets that along the leg, and the limbs end there. Index 0 left (+x), 1 right.
struct ScanLimbs {
  std::vector<ScanLimb> limb;  ///< per vertex
  std::array<LimbChain, 2> arm, leg;
};

/// How far an upper arm is raised from hanging down [°].
double raised_deg(const LimbChain& arm);

/// `mesh` closed, z up, facing -y, floor at z = 0. What is not found has an empty chain.
/// Hanging arms that part from the trunk lower than any armpit lies have grown together with it:
/// their fold is put where armpits usually are, 0.745 of the stature, along the inside of the arm.
ScanLimbs find_limbs(const geometry::TriangleMesh& mesh, double height);

}  // namespace loosefit::body

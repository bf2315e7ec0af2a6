#pragma once
#include <map>
#include <optional>
#include <string>

#include "loosefit/body/body.h"

namespace loosefit::placement {

/// Directions of the trunk in this posture, unit and at right angles to each other.
struct TrunkAxes {
  Vec3 right, front, down;
  Vec3 middle;  ///< a point inside the trunk in its middle plane, at breast to waist level [m]
  /// The middle of the trunk at the level of a point: moved along `down` only.
  Vec3 middle_at(const Vec3& level) const { return middle + down.dot(level - middle) * down; }
};

/// Right from the acromia (or shoulder joints), down from C7 to the back waist; an upright wearer's
/// where the body lacks them. Nothing without the landmarks sternum and back_waist.
std::optional<TrunkAxes> trunk_axes(const body::Body& body);

/// Flexion of an elbow or knee: directions of the two bones that meet there, and the inside of the
/// bend.
struct BentLimb {
  Vec3 joint;         ///< [m]
  Vec3 upper, lower;  ///< unit, from the trunk outwards along the limb
  Vec3 across;        ///< unit, the hinge; from the wearer's left to the right when the limb hangs
  Vec3 front;         ///< unit, normal to `across`, bisects the bend; cubital fossa, knee cap
};

/// The arm of one side (+1 left). Hinge: normal of the plane of upper arm and forearm; of an arm
/// bent by less than 10° the trunk's right. Nothing without its joints.
std::optional<BentLimb> arm_of(const body::Body& body, int side);
/// The leg. Hinge: the line through the hip joints, square to the thigh. Nothing without joints.
std::optional<BentLimb> leg_of(const body::Body& body, int side);

/// Palpable landmarks beyond those of the body, where a geometric rule finds them on its surface
/// (docs/theory/sensor_metrics.md 9): xiphoid (breast level to navel, 30 %: the underbust level),
/// asis_L/R and psis (the middle one) from the hip joints by the regression of Bell, Pedersen and
/// Brand (1990), epicondyle_{medial,lateral}_L/R, olecranon_L/R, cubital_fossa_L/R,
/// wrist_{medial,lateral}_L/R (styloids; of the pronated forearm medial is radial), trochanter_L/R,
/// knee_{medial,lateral}_L/R, patella_L/R, popliteal_L/R, malleolus_{medial,lateral}_L/R. Each is
/// where a ray from the trunk's middle or from the joint leaves the skin; good to some millimetres
/// on the geometry, to a centimetre or two on the anatomy. What the body has no joints for is
/// missing.
std::map<std::string, Vec3> address_landmarks(const body::Body& body);

}  // namespace loosefit::placement

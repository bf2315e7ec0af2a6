#pragma once
#include "loosefit/body/body_path.h"
#include "loosefit/pattern/pattern.h"

namespace loosefit::validate {

/// An arm of two cones that meet in an elbow, its upper arm a little raised and the forearm hanging
/// down from it, so that a sleeve lies on it like on a ridge and stays without being held.
struct BentArm {
  double shoulder_radius = 0.045, elbow_radius = 0.038, wrist_radius = 0.028;  ///< [m]
  double upper_length = 0.26, fore_length = 0.26;  ///< along the middle line [m]
  double bend = radians(45.0);                     ///< of the elbow [rad]
  double raise = radians(10.0);                    ///< of the upper arm above the horizontal [rad]
  double turn_radius = 0.06;                       ///< of the middle line in the elbow [m]

  /// Radius at the distance `s` from the shoulder along the middle line [m].
  double radius(double s) const;
  /// The arm with its elbow bent by `share` of `bend`; it knows how its skin moves with it.
  body::Body at(double share) const;
  /// From straight to bent.
  body::BodyPath path() const;

  /// A sleeve from `from` to `to` along the arm [m] of two equal pieces, front and back, whose
  /// girth is that of the straight arm times 1 + `ease` at every station; placed round the straight
  /// arm.
  pattern::Pattern sleeve(double ease, double from, double to) const;

 private:
  Vec3 straight() const;  ///< direction of the unbent arm
};

}  // namespace loosefit::validate

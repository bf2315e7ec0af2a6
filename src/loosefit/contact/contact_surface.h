#pragma once
#include "loosefit/base/types.h"

namespace loosefit::contact {

/// A surface that cloth may touch from one side, as the signed distance to it.
class ContactSurface {
 public:
  struct Sample {
    double distance = 0;  ///< [m], negative behind the surface
    Vec3 gradient = Vec3::Zero();
    Mat3 hessian = Mat3::Zero();  ///< [1/m]
  };
  virtual ~ContactSurface() = default;
  /// False when p lies farther than `reach` before the surface: then only a lower bound of the
  /// distance is given. The derivatives are those of the distance that is given, so that an energy
  /// of it is exactly integrable.
  virtual bool sample(const Vec3& p, double reach, bool with_hessian, Sample& out) const = 0;
};

}  // namespace loosefit::contact

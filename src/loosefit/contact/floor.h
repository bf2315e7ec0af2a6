#pragma once
#include "loosefit/contact/contact_surface.h"

namespace loosefit::contact {

/// A rigid, level, endless floor: the distance of a point is its height above it.
class Floor : public ContactSurface {
 public:
  /// height: z of the floor [m]
  explicit Floor(double height) : height_(height) {}
  double height() const { return height_; }
  bool sample(const Vec3& p, double reach, bool with_hessian, Sample& out) const override {
    out.distance = p.z() - height_;
    if (!(out.distance < reach)) return false;
    out.gradient = Vec3::UnitZ();
    if (with_hessian) out.hessian.setZero();
    return true;
  }

 private:
  double height_;
};

}  // namespace loosefit::contact

#pragma once
#include "loosefit/base/types.h"
#include "loosefit/fabric/plane_law.h"

namespace loosefit::fabric {

/// Inner friction of a bent fabric: the hysteresis 2HB of the KES bending test, as a Jenkin element
/// (spring and slider in series) beside the elastic sheet (docs/theory/validation.md 2.3).
///
/// With z = (a_u κ_uu, a_v κ_vv, √(a_u a_v/2) 2κ_uv) − z₀, a_i = HB_i/H̄, H̄ = max HB_i:
///
///   w = H̄ κ_r f₀(|z|/κ_r),  f₀' = s (2 − s) for s < 1, 1 beyond                       [J/m²]
///
/// so that the moment of pure bending in warp never exceeds HB_v (in weft HB_u) and a strip that
/// is released from a tight bend stops at κ_res = HB/B. z₀ follows by return mapping at the start
/// of every step: not conservative over steps, within a step a potential.
/// κ_r is the least of a_i κ_res,i / 10, so that in either direction the yarns slide after an
/// elastic reach of at most a tenth of the curvature that they would keep.
class BendingFriction {
 public:
  /// hysteresis HB [N] and rigidity B [N m], weft and warp. Inactive when both HB are 0.
  BendingFriction(const Vec2& hysteresis, const Vec2& rigidity);
  bool active() const { return limit_ > 0; }
  double reach() const { return reach_; }  ///< κ_r [1/m]

  /// z before z₀ is taken off, for κ = (κ_uu, κ_vv, 2κ_uv).
  Vec3 slide(const Vec3& curvature) const { return scale_.cwiseProduct(curvature); }
  /// z₀ of the next step, for the z at which this one ended: never farther than κ_r from it.
  Vec3 carried(const Vec3& slide, const Vec3& anchor) const;

  struct Response {
    double energy = 0;            ///< w [J/m²]
    Vec3 moment = Vec3::Zero();   ///< ∂w/∂κ [N]
    Mat3 tangent = Mat3::Zero();  ///< ∂²w/∂κ² [N m], positive semi-definite
  };
  Response respond(const Vec3& curvature, const Vec3& anchor) const;
  /// The same without the tangent for a tile of triangles: adds area × energy and moment.
  void add(const PlaneRows& curvature, const PlaneRows& anchor, const particles::TileRow& area,
           PlaneResponse& out) const;

 private:
  double limit_ = 0;  ///< H̄ [N]
  double reach_ = 1;
  Vec3 scale_ = Vec3::Zero();
};

}  // namespace loosefit::fabric

#include "loosefit/placement/segment_direction.h"

#include <cmath>

#include "loosefit/body/body_frame.h"
#include "loosefit/placement/address_garment.h"

namespace loosefit::placement {

SegmentDirection::SegmentDirection(const garment::Garment& garment,
                                   const std::vector<Vec3>& positions, const body::PosedBody& body,
                                   const maps::WornGarment& worn)
    : angles_(garment.triangles.size(), 0.0) {
  const std::vector<Vec3>& axes = body.axes();
  std::vector<Vec3> axis_at_vertex;
  for (const body::BodyPartner& partner : worn.partners)
    axis_at_vertex.push_back(
        body::at_point(body->surface, axes, partner.exact.triangle, partner.exact.barycentric));
  for (int t = 0; t < static_cast<int>(garment.triangles.size()); ++t) {
    Vec3 axis = Vec3::Zero(), normal = Vec3::Zero();
    for (int v : garment.triangles[t]) {
      axis += axis_at_vertex[v];
      normal += worn.partners[v].normal;
    }
    if (axis.norm() < 1e-6 || normal.norm() < 1e-6) continue;
    // The cloth may be folded over: what counts is whether the body has a direction there.
    if (!body::surface_frame(normal.normalized(), axis.normalized()).has_direction) continue;
    const double angle = angle_in_pattern(garment, positions, {t}, axis.normalized());
    if (std::isfinite(angle)) angles_[t] = angle;
  }
}

}  // namespace loosefit::placement

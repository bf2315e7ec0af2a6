#pragma once
#include <vector>

#include "loosefit/body/body.h"
#include "loosefit/geometry/closest_point.h"

namespace loosefit::body {

/// Long axis of the body segment at every surface vertex, unit, from the far end of the segment to
/// the near one (docs/theory/sensor_metrics.md 3.1): wrist → elbow, elbow → shoulder, ankle → knee,
/// knee → hip, hand → wrist; neck → head. Limbs take it from the joints. The trunk's axis is the
/// upright of the rest posture, carried with the skin (pose_from_rest), so that the chest of a bent
/// wearer leans with the chest; a body that is known in one posture only (a scan) has pelvis →
/// neck. Zero where the joints are not known, and on the feet.
std::vector<Vec3> segment_axes(const Body& body);

/// Right-handed frame at a place of a surface; the columns of `axes` are s = a × n, a, n with n the
/// outward normal and a a direction in the tangent plane. On the back of an upright wearer a points
/// up, n backwards and s to the wearer's right; on the breast s points to the left.
struct SurfaceFrame {
  Mat3 axes = Mat3::Identity();
  /// False: the wanted direction is not known or nearly normal (on top of the shoulders the trunk's
  /// axis is); then a is any tangent and nothing but n may be read from the frame.
  bool has_direction = false;
};

/// A wanted direction within this angle to the normal gives no direction on the surface [rad].
inline constexpr double kLeastInclination = 0.2617993877991494;  // 15°

/// Frame with normal `normal` (unit) and a the projection of `direction` (unit, or zero).
SurfaceFrame surface_frame(const Vec3& normal, const Vec3& direction);

/// A body field given per surface vertex at a point of the surface, linear over the triangle.
Vec3 at_point(const geometry::TriangleMesh& surface, const std::vector<Vec3>& per_vertex,
              int triangle, const Vec3& barycentric);

/// A point of the skin that keeps its place in the skin when the body moves: the material partner
/// of docs/theory/sensor_metrics.md 1, with a direction that moves along.
struct SkinPoint {
  int triangle = -1;
  Vec3 barycentric = Vec3::Zero();
  Vec2 direction = Vec2::Zero();  ///< in the edges of the triangle from its first corner
  bool has_direction = false;     ///< it is the segment's long axis, not just any tangent
};

/// The skin under `at` on the reference body; `axes` are segment_axes(reference). Where they give
/// no direction, the projection of `otherwise` is carried (zero: any tangent).
SkinPoint skin_point(const Body& reference, const std::vector<Vec3>& axes,
                     const geometry::ClosestPoint& at, const Vec3& otherwise = Vec3::Zero());

/// Where the skin point is on another posture of the same body [m].
Vec3 position_of(const SkinPoint& point, const Body& now);

/// Frame there: smooth normal, direction carried by the deformation of the skin.
SurfaceFrame frame_of(const SkinPoint& point, const Body& now);

/// \throws InvalidInput unless both are the same wearer's body in two postures, that is their
/// surfaces have the same triangles.
void require_same_wearer(const Body& reference, const Body& now);

}  // namespace loosefit::body

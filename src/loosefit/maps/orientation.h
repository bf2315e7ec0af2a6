#pragma once
#include <vector>

#include "loosefit/garment/garment.h"
#include "loosefit/maps/worn_garment.h"

namespace loosefit::maps {

/// Orientation of a place of the garment relative to the body under it, R = F_bᵀ F_g with the body
/// frame F_b = [s a n] (body/body_frame.h) and the garment frame F_g of the same build, its a the
/// image of a direction in the pattern (docs/theory/sensor_metrics.md 3.1, 3.2). All in rad.
///
/// R is a swing, which takes n_b to n_g the shortest way, after a twist about n_b. The swing's
/// rotation vector τ lies in the tangent plane of the body; it is split into the two tilts:
///
///   |τ| = AD,   τ = tilt_sagittal · s_b + tilt_lateral · a_b
///
/// and cos(rotation/2) = cos(AD/2) cos(twist/2). A direction fixed in the garment differs from the
/// same direction fixed in the body by at most `rotation`, the normal by AD.
struct Orientation {
  double angular_deviation = 0;  ///< AD, angle between the normals, 0 … π
  /// About s: positive where the cloth's normal leans to the far end of the segment (on the trunk:
  /// down), as when the upper edge of a board stands off further than the lower one.
  double tilt_sagittal = 0;
  /// About a: positive where the normal leans towards s (back: wearer's right; breast: left).
  double tilt_lateral = 0;
  /// About the normal, −π … π, positive counter-clockwise seen from outside.
  double twist = 0;
  double rotation = 0;  ///< total angle of R, 0 … π
  /// τ about the axes of the garment frame instead, which the twist has turned against s and a: of
  /// a sensor across and along its own axis.
  double tilt_across() const;
  double tilt_along() const;
};

/// \pre `relative` is a rotation, or NaN as the result then is. The tilts are NaN for opposite
/// normals and the twist then too: every way round is as short.
Orientation orientation_of(const Mat3& relative);

/// Angle of a rotation, 0 … π [rad]; exact also near zero.
double rotation_angle(const Mat3& rotation);

/// Direction in the pattern (weft, warp) that stands for a sensor's long axis when nothing is said.
inline const Vec2 kGrain = Vec2(0, 1);

/// Frame of a garment triangle: n its normal, a = F d/|F d| (in its plane anyway), s = a × n; all
/// NaN for a triangle without area.
Mat3 triangle_frame(const garment::Garment& garment, int triangle,
                    const std::vector<Vec3>& positions, const Vec2& direction = kGrain);

/// Frame at every garment vertex: the vertex normal (unit, from `normals`), and the mean of F d
/// over the triangles round the vertex in its own panel (Garment::vertex_panel; across a seam the
/// pattern directions of two panels need not agree), weighted by flat area and projected.
std::vector<Mat3> vertex_frames(const garment::Garment& garment, const std::vector<Vec3>& positions,
                                const std::vector<Vec3>& normals, const Vec2& direction = kGrain);

/// Angle between two unit vectors as atan2(|a × b|, a · b), exact also near zero [rad].
double angle_between(const Vec3& a, const Vec3& b);

/// Of every vertex of the cloth, in its vertex_frames, against the body at its partner; all NaN
/// where the body gives no long axis (SurfaceFrame::has_direction).
std::vector<Orientation> vertex_orientations(const garment::Garment& garment,
                                             const std::vector<Vec3>& positions,
                                             const WornGarment& worn,
                                             const Vec2& direction = kGrain);

}  // namespace loosefit::maps

#pragma once
#include <map>
#include <vector>

#include "loosefit/garment/garment.h"
#include "loosefit/maps/worn_garment.h"

namespace loosefit::maps {

/// Width (standard deviation) of the smoothing that tells wrinkles from the shape the cloth hangs
/// in [m]: folds nearer together than about four times as much are wrinkles.
inline constexpr double kWrinkleWidth = 0.03;

/// The folds of a piece of cloth in three numbers.
struct WrinkleDirection {
  /// Of the lines of the folds against the long axis of the body segment (on the trunk: the
  /// vertical), −π/2 < angle ≤ π/2, positive counter-clockwise seen from outside [rad].
  double angle = 0;
  double coherence = 0;  ///< 0 no direction is preferred … 1 all folds run alike
  double slope = 0;      ///< rms tilt of the cloth out of its smoothed shape [rad]
};

/// Unit normals of the garment smoothed over its flat surface, seams passed: diffusion until
/// `width`²/2, in a few implicit steps, which leaves 1/(1 + k² width²/(2·4))⁴ of a wave of wave
/// number k and is near a Gaussian of that width. Natural edges.
std::vector<Vec3> smoothed_normals(const garment::Garment& garment,
                                   const std::vector<Vec3>& normals, double width = kWrinkleWidth);

/// Tilt of the cloth at every vertex out of its smoothed shape, that is the deviation of the
/// normal from the smoothed normal m: rotation angle times its direction, in the frame (s, a) of
/// body/body_frame.h about m with a along the body segment [rad]. For a small wrinkle of height h
/// it is −∇h. NaN where the segment's axis is not known or nearly normal.
std::vector<Vec2> wrinkle_slopes(const garment::Garment& garment, const WornGarment& worn,
                                 double width = kWrinkleWidth);

/// Direction of the folds from the structure tensor J = Σ area · p pᵀ / Σ area of slopes p (Bigün
/// and Granlund 1987; docs/theory/sensor_metrics.md 11): the folds run square to its first
/// eigenvector, coherence is the difference of its eigenvalues over their sum, slope² is that sum.
/// Entries with a NaN are left out; all NaN when none is left.
WrinkleDirection wrinkle_direction(const std::vector<Vec2>& slopes,
                                   const std::vector<double>& areas);

/// The same for each region of the body that the garment covers and whose segment has an axis.
std::map<body::Region, WrinkleDirection> regional_wrinkles(const garment::Garment& garment,
                                                           const WornGarment& worn,
                                                           double width = kWrinkleWidth);

}  // namespace loosefit::maps

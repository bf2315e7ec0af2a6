#pragma once
#include <string>
#include <vector>

#include "loosefit/garment/garment.h"
#include "loosefit/geometry/triangle_mesh.h"

namespace loosefit::placement {

/// Radius over which a sensor averages when nothing is said: an IMU board [m]
/// (docs/theory/sensor_metrics.md 1).
inline constexpr double kFootprintRadius = 0.012;

/// What a sensor covers of the flat cloth. Its axis is `angle` from the warp, counter-clockwise in
/// the pattern's own (u, v) axes: 0 along v, 90° along −u.
struct FootprintShape {
  enum class Kind {
    disc,
    rectangle,
    line,   ///< centred on the site, along the axis
    girth,  ///< all the way round the body, through the site
  } kind = Kind::disc;
  double radius = kFootprintRadius;  ///< disc [m]
  Vec2 size = Vec2::Zero();          ///< rectangle: across and along the axis [m]
  double length = 0;                 ///< line [m]
};

/// Unit vector of a sensor's axis in the pattern (FootprintShape).
Vec2 axis_in_pattern(double angle);

/// The patch of cloth under a sensor: sample points of equal footing with their share of the area.
struct Footprint {
  struct Sample {
    int triangle = 0;
    Vec3 barycentric = Vec3::Zero();
    double area = 0;  ///< draped [m²]; of a line or girth: share of the flat length [m]
  };
  std::vector<Sample> samples;
};

/// The cloth under a disc, a rectangle or a line whose centre lies at `barycentric` of `triangle`.
/// Measured in the flat cloth, so the same patch in every drape: beyond a seam the next piece is
/// laid flat against the nearest stretch of it, and what would lie beyond a free edge is left out.
/// Never empty. Who makes many gives the garment's triangle_neighbours (footprint_unfold.h).
/// \throws InvalidInput for a girth, which needs the drape (girth_footprint).
Footprint footprint(const garment::Garment& garment, const std::vector<Vec3>& positions,
                    int triangle, const Vec3& barycentric, const FootprintShape& shape,
                    double angle, const std::vector<std::array<int, 3>>* neighbours = nullptr);

/// The same for a disc.
Footprint footprint(const garment::Garment& garment, const std::vector<Vec3>& positions,
                    int triangle, const Vec3& barycentric, double radius);

/// The line in which the draped garment is cut by the plane through the place with this normal:
/// that piece of it which hangs together with the place. One sample per triangle, half way.
/// \throws InvalidInput for a normal of length zero.
Footprint girth_footprint(const garment::Garment& garment, const std::vector<Vec3>& positions,
                          int triangle, const Vec3& barycentric, const Vec3& normal);

/// "disc of 24 mm", "40 x 30 mm" (across and along the axis), "line of 60 mm", "girth".
std::string in_words(const FootprintShape& footprint);

/// Area of a footprint [m²]; 0 for a line and a girth.
double area(const FootprintShape& footprint);
/// Radius of the circle about a footprint [m]; 0 for a girth, which goes across everything.
double outer_radius(const FootprintShape& footprint);

/// A map's values in a sensor's footprint.
struct FootprintValue {
  double mean = 0;   ///< area mean over the footprint
  double worst = 0;  ///< the 5 % of the footprint that are highest start here
};

/// Mean and worst of a vertex field over the footprint; NaN vertices are passed over.
FootprintValue average(const Footprint& footprint, const garment::Garment& garment,
                       const std::vector<double>& vertex_values);

}  // namespace loosefit::placement

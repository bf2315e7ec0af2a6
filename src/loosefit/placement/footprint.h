#pragma once
#include <vector>

#include "loosefit/garment/garment.h"
#include "loosefit/geometry/triangle_mesh.h"
#include "loosefit/placement/sites.h"

namespace loosefit {

/// The patch of cloth under a sensor: sample points of equal footing with their share of the area.
struct Footprint {
  struct Sample {
    int triangle = 0;
    Vec3 barycentric = Vec3::Zero();
    double area = 0;  ///< draped [m²]
  };
  std::vector<Sample> samples;
};

/// All cloth within `radius` of `centre` that hangs together with `triangle`, in which the centre
/// lies; a neighbouring fold layer does not count. Never empty.
Footprint footprint(const Garment& garment, const std::vector<Vec3>& positions, int triangle,
                    const Vec3& barycentric, double radius);

/// Mean and worst of a vertex field over the footprint; NaN vertices are passed over.
FootprintValue average(const Footprint& footprint, const Garment& garment,
                       const std::vector<double>& vertex_values);

}  // namespace loosefit

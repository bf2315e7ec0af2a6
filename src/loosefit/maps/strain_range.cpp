#include "loosefit/maps/strain_range.h"

#include <algorithm>
#include <cmath>

#include "loosefit/maps/cloth_strain.h"
#include "loosefit/maps/definitions/trellis_shear.h"
#include "loosefit/maps/strain.h"

namespace loosefit::maps {
namespace {

/// Takes note of one triangle in the strain range of one direction; whether it is beyond the limit.
bool add(DirectionRange& range, double value, double area) {
  range.largest = std::max(range.largest, value);
  const bool beyond = range.is_stated() && value > range.limit;
  if (beyond) range.share_beyond += area;
  return beyond;
}

bool is_far_beyond(const DirectionRange& range, double value) {
  return range.is_stated() && value > kFarBeyond * range.limit;
}

}  // namespace

StrainRange strain_range(const garment::Garment& garment, const std::vector<Vec3>& positions,
                         const fabric::Material& material) {
  StrainRange range;
  range.warp.limit = material.valid_strain_warp;
  range.weft.limit = material.valid_strain_weft;
  range.shear.limit = material.valid_shear;
  double total = 0;
  const std::vector<ClothStrain> strains = cloth_strains(garment, positions, material);
  for (std::size_t t = 0; t < garment.triangles.size(); ++t) {
    const geometry::DeformationGradient& f = strains[t].yarns;
    const TriangleStrain strain = triangle_strain(f);
    if (!std::isfinite(strain.warp)) continue;  // no flat area
    const double area = geometry::flat_area(garment.triangle_uv[t]);
    total += area;
    const bool warp = add(range.warp, strain.warp, area), weft = add(range.weft, strain.weft, area);
    if (add(range.shear, std::abs(trellis_shear(f)), area) || warp || weft)
      range.share_beyond += area;
    if (is_far_beyond(range.warp, strain.warp) || is_far_beyond(range.weft, strain.weft))
      range.share_far_beyond += area;
  }
  if (total > 0)
    for (double* share : {&range.warp.share_beyond, &range.weft.share_beyond,
                          &range.shear.share_beyond, &range.share_beyond, &range.share_far_beyond})
      *share /= total;
  return range;
}

}  // namespace loosefit::maps

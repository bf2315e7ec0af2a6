#include "loosefit/maps/strain_range.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "loosefit/body/regions.h"
#include "loosefit/drape/rims.h"
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

constexpr double kCrushed = -0.5;  ///< strain [–]
constexpr double kTears = 0.35;  ///< where the card states nothing (docs/theory/materials.md 8) [–]

constexpr double kTornShare = 0.5;   ///< of the cloth of a region
constexpr double kTornArea = 20e-4;  ///< [m²], that no single bad triangle makes up

/// Infinite where nothing is stated.
double bears(double valid, double stretch) {
  const double most = drape::borne_strain(valid, stretch);
  return most > 0 ? most : std::numeric_limits<double>::infinity();
}

/// The same where nothing is stated, as of the toughest wovens.
double tears_at(double valid, double stretch) {
  const double most = bears(valid, stretch);
  return std::isfinite(most) ? most : kTears;
}

}  // namespace

StrainRange strain_range(const garment::Garment& garment, const std::vector<Vec3>& positions,
                         const fabric::Material& material) {
  StrainRange range;
  range.warp.limit = material.valid_strain_warp;
  range.weft.limit = material.valid_strain_weft;
  range.shear.limit = material.valid_shear;
  const double warp_bears = tears_at(material.valid_strain_warp, material.stretch_warp),
               weft_bears = tears_at(material.valid_strain_weft, material.stretch_weft);
  double total = 0;
  const std::vector<ClothStrain> strains = cloth_strains(garment, positions, material);
  for (std::size_t t = 0; t < garment.triangles.size(); ++t) {
    const geometry::DeformationGradient& f = strains[t].yarns;
    const TriangleStrain strain = triangle_strain(f);
    const double area = geometry::flat_area(garment.triangle_uv[t]);
    total += area;
    const bool warp = add(range.warp, strain.warp, area), weft = add(range.weft, strain.weft, area);
    if (add(range.shear, std::abs(trellis_shear(f)), area) || warp || weft)
      range.share_beyond += area;
    const TriangleStrain raw =
        triangle_strain(garment_gradient(garment, static_cast<int>(t), positions));
    const double least = std::min(raw.warp, raw.weft), most = std::max(raw.warp, raw.weft);
    if (least < kCrushed) range.crushed.push_back(static_cast<int>(t));
    if (raw.warp > warp_bears || raw.weft > weft_bears) range.torn.push_back(static_cast<int>(t));
    range.least = std::min(range.least, least);
    range.most = std::max(range.most, most);
  }
  if (total > 0)
    for (double* share : {&range.warp.share_beyond, &range.weft.share_beyond,
                          &range.shear.share_beyond, &range.share_beyond})
      *share /= total;
  return range;
}

std::vector<TornRegion> torn_regions(const garment::Garment& garment,
                                     const std::vector<Vec3>& positions,
                                     const fabric::Material& material,
                                     const body::PosedBody& body) {
  const double warp_bears = bears(material.valid_strain_warp, material.stretch_warp),
               weft_bears = bears(material.valid_strain_weft, material.stretch_weft);
  const auto is_torn = [&](const TriangleStrain& strain) {
    return strain.warp > warp_bears || strain.weft > weft_bears;
  };
  std::vector<TriangleStrain> strains;
  double torn_area = 0;
  for (const ClothStrain& cloth : cloth_strains(garment, positions, material)) {
    if (is_torn(strains.emplace_back(triangle_strain(cloth.yarns))))
      torn_area += geometry::flat_area(garment.triangle_uv[strains.size() - 1]);
  }
  if (torn_area <= kTornArea) return {};  // most garments: the skin need not be asked

  struct Sum {
    double area = 0, torn = 0, warp = 0, weft = 0;
  };
  std::map<int, Sum> of_region;
  const bool parted = body->segment.size() == body->surface.vertices.size();
  for (std::size_t t = 0; t < strains.size(); ++t) {
    const TriangleStrain& strain = strains[t];
    const Triangle& c = garment.triangles[t];
    const Vec3 middle = (positions[c[0]] + positions[c[1]] + positions[c[2]]) / 3;
    const int region = parted ? static_cast<int>(body::region_of(body.regions(), body->surface,
                                                                 body.tree().query(middle)))
                              : -1;
    const double area = geometry::flat_area(garment.triangle_uv[t]);
    Sum& sum = of_region[region];
    sum.area += area;
    if (is_torn(strain)) sum.torn += area;
    sum.warp = std::max(sum.warp, strain.warp);
    sum.weft = std::max(sum.weft, strain.weft);
  }
  std::vector<TornRegion> torn;
  for (const auto& [region, sum] : of_region) {
    if (sum.torn <= kTornShare * sum.area || sum.torn <= kTornArea) continue;
    const bool warp = sum.warp / warp_bears > sum.weft / weft_bears;
    torn.push_back({region < 0 ? "the body" : body::name(static_cast<body::Region>(region)),
                    sum.torn / sum.area, warp, warp ? sum.warp : sum.weft,
                    warp ? warp_bears : weft_bears});
  }
  return torn;
}

}  // namespace loosefit::maps

#pragma once
#include <functional>
#include <vector>

#include "loosefit/body/posed_body.h"
#include "loosefit/garment/garment.h"
#include "loosefit/maps/worn_garment.h"

namespace loosefit::maps {

/// Air between a garment and the skin under it. The mean gap of a region is volume over skin area,
/// as in the literature, not the mean of nearest distances, which folds make shorter
/// (docs/theory/air_gap.md 1).
struct AirGap {
  double volume = 0;     ///< between the cloth's inner face and the skin [m³]
  double skin_area = 0;  ///< under the cloth [m²]
  double mean_gap() const { return volume / skin_area; }  ///< [m]
};

/// Of the garment triangles that `counts` (all when empty). Each spans a prism down to the partners
/// of its corners on the skin; prisms of neighbours share their sides, so that volumes add up to
/// what the cloth encloses, whatever its folds. Skin that is nobody's partner, in a bridged hollow,
/// is replaced by the chord across it; so is skin between the partners of a coarse mesh
/// (maps/fine_cloth.h). `half_thickness`: of the cloth [m], from its middle surface
/// to the inner face. \throws InvalidInput when positions do not fit.
AirGap air_gap(const garment::Garment& garment, const std::vector<Vec3>& positions,
               const WornGarment& worn, double half_thickness,
               const std::function<bool(int triangle)>& counts = {});

/// The volume of the same prisms between two heights [m³]: of a slanted prism, and at the ends of a
/// body that slants, what lies between the heights, not what the cloth between them covers.
double air_between(const garment::Garment& garment, const std::vector<Vec3>& positions,
                   const WornGarment& worn, double half_thickness, double low, double high,
                   const std::function<bool(int triangle)>& counts = {});

/// Gap of every vertex of the body's skin to the inner face of the nearest cloth [m], not below
/// zero; NaN where no cloth lies over it: the nearest is a border, farther than 0.15 m, or behind
/// the skin.
std::vector<double> skin_gaps(const body::Body& body, const garment::Garment& garment,
                              const std::vector<Vec3>& positions, double half_thickness);

/// Share of the covered skin of `skin_vertices` whose gap is below `g0` [m]; NaN where none is
/// covered. Scans call 1 mm contact, electrodes 0.1 to 0.5 mm (docs/theory/air_gap.md 1).
double contact_share(const body::Body& body, const std::vector<double>& gaps, double g0,
                     const std::function<bool(int vertex)>& counts = {});

}  // namespace loosefit::maps

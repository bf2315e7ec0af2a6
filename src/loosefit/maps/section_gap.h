#pragma once
#include <array>
#include <optional>
#include <vector>

#include "loosefit/body/posed_body.h"
#include "loosefit/garment/garment.h"
#include "loosefit/maps/worn_garment.h"

namespace loosefit::maps {

/// A horizontal section through a body and the cloth round it, seen from above: x to the wearer's
/// left, y backwards. Bounds that hold for any cloth: docs/theory/air_gap.md 2.
struct SectionGap {
  double level = 0;                         ///< height [m]
  double body_area = 0, body_girth = 0;     ///< [m²], [m]
  double cloth_area = 0, cloth_girth = 0;   ///< inside the cloth's middle surface; folds followed
  double body_width = 0, body_depth = 0;    ///< extents along x and y [m]
  double cloth_width = 0, cloth_depth = 0;  ///< the same of the cloth [m]
  double opened = 0;  ///< skin that closes the cloth where armholes open it [m]; part of its girth
  /// Air in the quadrants round the middle of the body, 45° to either side of the wearer's left,
  /// back, right and front [m²]; they sum to gap_area().
  std::array<double, 4> quadrant = {};
  std::vector<double>
      gap;  ///< along evenly spaced rays from the middle, outermost cloth − skin [m]

  double gap_area() const { return cloth_area - body_area; }
  /// Air over skin: the mean gap of a thin slice [m].
  double mean_gap() const { return gap_area() / body_girth; }
  /// Share of the air that this much cloth could enclose as a round tube, P²/4π − A: between 0 and
  /// 1, lower by folds and by cloth that lies on a body that is not round. NaN without slack.
  double filling() const;
};

/// From two closed polygons of either turn round `middle`. \throws InvalidInput for fewer than
/// three corners, or a middle outside one of them.
SectionGap section_gap(std::vector<Vec2> body, std::vector<Vec2> cloth, const Vec2& middle,
                       int rays = 72);

/// The section at height `level` of the trunk without arms and of the panels that belong to it.
/// Nothing where one of them has no closed section there: above the armpits, below the hem.
///
/// Where armholes reach below `level` the cloth is open at the sides. With `most_open` it is closed
/// along the skin from each end of the cloth to the next, if each way is at most so long [m]: what
/// is bare there has no air over it, as on a scan. A way leaves an end of the cloth for the skin
/// nearest to it; open pieces of less than 30 mm, tips of a wavy edge, are left out.
std::optional<SectionGap> trunk_section(const garment::Garment& garment,
                                        const std::vector<Vec3>& positions, const WornGarment& worn,
                                        const body::Body& body, double level, double most_open = 0);

}  // namespace loosefit::maps

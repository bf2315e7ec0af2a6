#pragma once
#include <optional>

#include "loosefit/placement/address_garment.h"

namespace loosefit::placement {

/// A point of the garment that was reached from another one over the flat cloth.
struct ShiftedPoint {
  GarmentPoint point;
  /// What the way turns a direction by, against the warp of the piece in which it ends,
  /// counter-clockwise [rad]; 0 where no seam is crossed.
  double turn = 0;
  bool mirrored = false;  ///< behind a right-to-wrong seam: turned over first

  /// An angle (FootprintShape) at the start as it is at `point`: the same where the way turns
  /// nothing, else from −π to π.
  double angle(double at_start) const;
};

/// The shift of a sensor: the point that lies `shift` [m] farther in the flat cloth, in weft and
/// warp of the panel of `point`. It is the end of a straight line that is drawn from triangle to
/// triangle. At a seam the next piece is laid flat against the mesh edge that the line crosses.
/// Nothing where the line leads over a free edge by more than 0.1 mm, even where cloth lies on the
/// other side of the gap.
std::optional<ShiftedPoint> shifted(const garment::Garment& garment, const GarmentPoint& point,
                                    const Vec2& shift);

}  // namespace loosefit::placement

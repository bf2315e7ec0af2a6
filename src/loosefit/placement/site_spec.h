#pragma once
#include <optional>
#include <string>

#include "loosefit/garment/attachment.h"
#include "loosefit/placement/address.h"
#include "loosefit/placement/footprint.h"
#include "loosefit/placement/line_spec.h"

namespace loosefit::placement {

/// The sensor as a part of the garment.
struct SensorBoard : garment::BoardMake {
  /// Extent across and along the sensor's axis [m]; zero: that of the footprint, which then is a
  /// disc or a rectangle.
  Vec2 size = Vec2::Zero();
};

/// Where a sensor is wanted, in one of three ways: a place in the pattern, a body landmark or
/// preset by name, or an anatomical address, and shifted from there; and what it is. Or a line.
struct SiteSpec {
  std::string name;
  std::string panel;                        ///< with `at`; wins over the other two
  Vec2 at = Vec2::Zero();                   ///< u (weft), v (warp) in the panel [m]
  std::string landmark = {};                ///< any of SitePoints::names
  std::optional<BodyAddress> anatomy = {};  ///< when neither panel nor landmark is given
  /// Of the sensor's axis in the pattern, where the place above lies (FootprintShape). A shift
  /// takes the axis along.
  double angle = 0;
  FootprintShape footprint = {};
  std::optional<SensorBoard> board = {};  ///< simulated as the body it is
  /// A sensor that is a line: then it has no place and footprint of the others, and is found by
  /// lines/find_course.h.
  std::optional<LineSpec> line = {};
  /// From the place above, along the cloth: weft and warp of the panel in which that lies [m]. On
  /// over seams (shift_along_cloth.h).
  Vec2 shift = Vec2::Zero();
};

}  // namespace loosefit::placement

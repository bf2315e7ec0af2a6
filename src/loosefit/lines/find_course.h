#pragma once
#include <vector>

#include "loosefit/lines/course.h"
#include "loosefit/placement/site_points.h"

namespace loosefit::lines {

/// Finds lines on a worn garment. Keeps references to garment, positions and `worn`.
class CourseFinder {
 public:
  CourseFinder(const garment::Garment& garment, const std::vector<Vec3>& positions,
               body::PosedBody body, const maps::WornGarment& worn);

  /// Where the stops of a line lie on the garment: places of the body go to the cloth over them
  /// (GarmentOverSkin). With `over` there is one more, half way between the first two: the address
  /// of the skin next to the middle between them, moved to that side of its segment. \throws
  /// InvalidInput, key "from", "via", "to" or "over", as find_sites, for a stop that the garment
  /// does not cover, and for a side that the segment does not have.
  std::vector<placement::GarmentPoint> stops(const placement::LineSpec& line) const;
  /// One place; `key` of messages.
  placement::GarmentPoint stop(const placement::LinePlace& place, const std::string& key) const;

  /// \throws InvalidInput as `stops` and lay_course.
  LineCourse find(const placement::LineSpec& line) const;
  const geometry::PathSurface& surface() const { return surface_; }

 private:
  geometry::ClosestPoint skin(const placement::LinePlace& place) const;
  placement::GarmentPoint side_stop(const placement::LineSpec& line,
                                    const placement::GarmentPoint& from,
                                    const placement::GarmentPoint& to) const;

  const garment::Garment& garment_;
  const std::vector<Vec3>& positions_;
  body::PosedBody body_;
  placement::GarmentOverSkin over_skin_;
  placement::SitePoints points_;
  geometry::PathSurface surface_;
};

/// "from", "via" or "to" of stop i of n.
std::string stop_key(std::size_t i, std::size_t n);

/// What can be said of a line before the garment is draped: panels, places in them, landmarks,
/// addresses. \throws InvalidInput, key "from", "via" or "to".
void check_stops(const garment::Garment& garment, const placement::SitePoints& points,
                 const placement::LineSpec& line);

}  // namespace loosefit::lines

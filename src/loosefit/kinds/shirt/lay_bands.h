#pragma once
#include <utility>
#include <vector>

#include "loosefit/garment/garment.h"
#include "loosefit/kinds/shirt/shirt_frame.h"

namespace loosefit::kinds {

/// Where a neckband goes, seen from the front [m]: rims as the edge of the neck of a shirt without
/// one, seams outside of them, so that the strips lie flat round the neck. All left → right.
struct NeckbandLines {
  std::vector<Vec2> front_rim, back_rim, front_seam, back_seam;
};
/// `width`: of the strip, 0 for none: rim and seam are one then.
NeckbandLines neckband_lines(const ShirtFrame& frame, double width, bool straight_neck);

/// Flat width of the strip that is this part, 0 without one [m].
double band_width(const garment::Garment& shirt, const char* part);

/// A line cut in two so that the last part is this share of its length.
std::pair<std::vector<Vec2>, std::vector<Vec2>> cut_line(const std::vector<Vec2>& line,
                                                         double last_share);

}  // namespace loosefit::kinds

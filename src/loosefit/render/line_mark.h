#pragma once
#include <string>
#include <vector>

#include "loosefit/base/types.h"
#include "loosefit/render/image.h"

namespace loosefit::render {

/// A line on the cloth that pictures show: a stretch sensor, a lead.
struct LineMark {
  std::string name;
  std::vector<Vec3> points;  ///< as worn [m]
};

/// Colour of the i-th line, told apart by people who are colour-blind (Okabe and Ito 2008); after
/// the sixth they come again.
Rgb line_colour(std::size_t i);

/// Names of the lines in their colours, in the upper left corner of a picture.
void draw_line_names(Image& image, const std::vector<LineMark>& lines);

}  // namespace loosefit::render

#pragma once
#include <vector>

#include "loosefit/io/svg/svg_document.h"
#include "loosefit/io/svg/svg_path.h"

namespace loosefit::io {

/// A line of a drawing.
struct SvgLine {
  const SvgShape* shape;
  SampledRun line;  ///< [m], y up
  double area = 0;  ///< of a closed one [m²]
};

/// Points of a drawing whose unit is `unit` [m] and whose y runs down, as metres with y up.
std::vector<Vec2> in_metres(std::vector<Vec2> points, double unit);

/// A run as points [m], y up; one whose ends meet is closed, whether or not a command says so.
SampledRun sampled_in_metres(const SvgRun& run, double unit);

Eigen::AlignedBox2d box_of(const std::vector<Vec2>& points);

/// Whether a closed line lies in another one or on it.
bool lies_inside(const std::vector<Vec2>& inner, const std::vector<Vec2>& outer);

}  // namespace loosefit::io

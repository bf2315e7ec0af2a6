#pragma once
#include <vector>

#include "loosefit/io/svg/svg_path.h"

namespace loosefit::io {

/// Points of a drawing whose unit is `unit` [m] and whose y runs down, as metres with y up.
std::vector<Vec2> in_metres(std::vector<Vec2> points, double unit);

/// A run as points [m], y up; one whose ends meet is closed, whether or not a command says so.
SampledRun sampled_in_metres(const SvgRun& run, double unit);

}  // namespace loosefit::io

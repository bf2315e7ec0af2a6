#pragma once
#include "loosefit/maps/performance_map.h"
#include "loosefit/render/image.h"

namespace loosefit::render {

/// Draws the map's colours as a horizontal bar with title, unit and ticks, five or at its breaks,
/// into the band of `height` pixels at the foot of `image`. Ends that stand for "and beyond" carry
/// ≤ and ≥.
void draw_legend(Image& image, const maps::PerformanceMap& map, int height);

/// Tick text without needless digits: 0.05 → "0.05", 20 → "20", −0.1 → "−0.1".
std::string tick_text(double value);

}  // namespace loosefit::render

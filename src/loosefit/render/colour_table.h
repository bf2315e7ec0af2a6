#pragma once
#include <array>
#include <cstdint>

#include "loosefit/maps/performance_map.h"

namespace loosefit::render {

using Rgb = std::array<std::uint8_t, 3>;
using ColourTable = std::array<Rgb, 256>;

/// Dark violet over blue, teal and green to yellow: a smooth path in OKLab (Ottosson 2020) through
/// the viridis anchors (van der Walt and Smith 2015), spaced so that neighbouring entries differ by
/// the same perceived amount. Lightness rises throughout, so it also reads in grey.
const ColourTable& sequential_colours();

/// Blue, near-white at zero, red: two straight paths in OKLab whose ends have the same lightness.
const ColourTable& diverging_colours();

/// The table a map is drawn with.
const ColourTable& colours_of(const maps::MapArrayStyle& map);

inline constexpr Rgb kUndefinedColour = {128, 128, 128};  ///< NaN

/// Place of a value on the map's colour bar: 0 at range_low, 1 at range_high, linear between the
/// map's breaks; beyond the ends it stays at them. NaN for NaN.
double colour_share(const maps::MapArrayStyle& map, double value);

}  // namespace loosefit::render

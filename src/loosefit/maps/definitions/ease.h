#pragma once
#include <limits>

#include "loosefit/maps/map_definition.h"

namespace loosefit::maps {

/// A field of the garment, one value per vertex; NaN where it has none.
inline std::vector<double> known_or_nan(const MapInput& in, const std::vector<double>& values) {
  if (!values.empty()) return values;
  return std::vector<double>(static_cast<std::size_t>(in.garment.vertex_count),
                             std::numeric_limits<double>::quiet_NaN());
}

/// Ease of the flat pieces against the body at the level of each place.
inline MapDefinition ease_map() {
  const auto array = [](const char* name, const char* map, const char* title, const char* meaning,
                        ReadField read, const char* metric, const char* words) {
    return MapArray{.style = {.array = name,
                              .title = title,
                              .range_low = -0.3,
                              .range_high = 0.3,
                              .map = map,
                              .pictured = false,
                              .diverging = true,
                              .percent = true},
                    .meaning = meaning,
                    .formula = "garment girth / body girth − 1",
                    .source = "Harms, Amft and Tröster 2012, section 2.1",
                    .read = read,
                    .metrics = {{metric, words, OverFootprint::mean, OverStates::reference}}};
  };
  return {
      .name = "ease",
      .arrays = {array("ease_cut", "ease", "Ease as cut",
                       "Girth of the flat pieces at the level of this place over the girth of the "
                       "body where the draft has it lie, less 1. Not known of pattern files.",
                       [](const MapInput& in) { return known_or_nan(in, in.garment.vertex_ease_cut); },
                       "ease_cut", "ease of the garment as cut, at the level of the sensor"),
                 array("ease_asked", "ease-asked", "Ease as asked",
                       "The ease that was asked for there, even between the levels of fit; not "
                       "defined where the draft follows no ease.",
                       [](const MapInput& in) {
                         return known_or_nan(in, in.garment.vertex_ease_asked);
                       },
                       "ease_asked", "ease that was asked for at the level of the sensor")},
      .by_default = true,
      .needs_ease = true,
      .made_with = "distance"};
}

}  // namespace loosefit::maps

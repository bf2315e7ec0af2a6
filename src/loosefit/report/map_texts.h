#pragma once
#include <string>

#include "loosefit/maps/performance_map.h"

// How the report writes what maps hold.
namespace loosefit::report {

/// "Body-garment distance [mm]". Strains are given in per cent, as people read them.
std::string with_unit(const maps::PerformanceMap& map);

/// A value of the map in that unit.
std::string value_text(const maps::PerformanceMap& map, double value);

/// Underscores of a name as spaces.
std::string spaced(std::string text);

}  // namespace loosefit::report

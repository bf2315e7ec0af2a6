#pragma once
#include <string>
#include <vector>

#include "loosefit/maps/map_definition.h"

namespace loosefit::maps {

/// All maps, in the order in which they are made, written and reported. One definition per header
/// of maps/definitions; a new map is a header there, a line in catalogue.cpp, a test, and its rows
/// in docs/maps.md (which a test compares with this).
const std::vector<MapDefinition>& map_catalogue();

/// The map of that name; nullptr when there is none.
const MapDefinition* find_map(const std::string& name);
/// The array of that name in any map; nullptr when there is none.
const MapArray* find_map_array(const std::string& array);

/// Words a scenario may use for maps: all but those that are made of several postures.
const std::vector<std::string>& map_names();
/// The paper's three and the trellis shear, made when nothing is said.
const std::vector<std::string>& default_map_names();

}  // namespace loosefit::maps

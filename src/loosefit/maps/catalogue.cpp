#include "loosefit/maps/catalogue.h"

#include "loosefit/maps/definitions/angular_deviation.h"
#include "loosefit/maps/definitions/crimp.h"
#include "loosefit/maps/definitions/distance.h"
#include "loosefit/maps/definitions/ease.h"
#include "loosefit/maps/definitions/gap.h"
#include "loosefit/maps/definitions/orientation.h"
#include "loosefit/maps/definitions/orientation_error.h"
#include "loosefit/maps/definitions/pressure.h"
#include "loosefit/maps/definitions/slip.h"
#include "loosefit/maps/definitions/strain.h"
#include "loosefit/maps/definitions/trellis_shear.h"

namespace loosefit::maps {
namespace {

std::vector<std::string> names_of(bool (*wanted)(const MapDefinition&)) {
  std::vector<std::string> names;
  for (const MapDefinition& map : map_catalogue())
    if (wanted(map)) names.push_back(map.name);
  return names;
}

}  // namespace

const std::vector<MapDefinition>& map_catalogue() {
  static const std::vector<MapDefinition> kMaps = {
      strain_map(),   trellis_shear_map(),     principal_strain_map(),
      distance_map(), angular_deviation_map(), crimp_map(),
      pressure_map(), orientation_map(),       gap_map(),
      slip_map(),     orientation_error_map(), ease_map(),
  };
  return kMaps;
}

const MapDefinition* find_map(const std::string& name) {
  for (const MapDefinition& map : map_catalogue())
    if (map.name == name) return &map;
  return nullptr;
}

const MapArray* find_map_array(const std::string& array) {
  for (const MapDefinition& map : map_catalogue())
    for (const MapArray& own : map.arrays)
      if (own.style.array == array) return &own;
  return nullptr;
}

const std::vector<std::string>& map_names() {
  static const std::vector<std::string> kNames =
      names_of([](const MapDefinition& map) { return !map.needs_postures; });
  return kNames;
}

const std::vector<std::string>& default_map_names() {
  static const std::vector<std::string> kNames =
      names_of([](const MapDefinition& map) { return map.by_default && map.made_with.empty(); });
  return kNames;
}

}  // namespace loosefit::maps

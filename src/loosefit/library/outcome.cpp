#include "loosefit/library/outcome.h"

namespace loosefit::library {

const MapArray* Garment::find_map(const std::string& array) const {
  for (const MapArray& map : maps)
    if (map.array == array) return &map;
  return nullptr;
}

}  // namespace loosefit::library

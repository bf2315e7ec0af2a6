#include "loosefit/maps/gap.h"

#include <algorithm>

#include "loosefit/maps/pressure.h"

namespace loosefit::maps {

double gap_of(double distance, const fabric::Material& material) {
  return std::max(0.0, distance - 0.5 * material.thickness);
}

bool touches(double gap, const fabric::Material& material) {
  return gap <= contact_tolerance(material);
}

}  // namespace loosefit::maps

#include "loosefit/maps/gap.h"

#include <algorithm>

#include "loosefit/maps/pressure.h"

namespace loosefit {

double gap_of(double distance, const Material& material) {
  return std::max(0.0, distance - 0.5 * material.thickness);
}

bool touches(double gap, const Material& material) { return gap <= contact_tolerance(material); }

std::vector<PerformanceMap> gap_maps(const WornGarment& worn, const Material& material) {
  PerformanceMap gap{"gap_mm", "Gap between the cloth's inner face and the skin", "mm", 0, 40, {},
                     "gap"};
  // Fine where electrodes and temperature sensors live, coarse where cloth hangs free.
  gap.breaks = {0, 0.5, 2, 5, 10, 20, 40};
  PerformanceMap contact{"contact", "Contact with the skin", "–", 0, 1, {}, "contact", false};
  for (const BodyPartner& partner : worn.partners) {
    const double distance = gap_of(partner.exact.distance, material);
    gap.values.push_back(1000 * distance);
    contact.values.push_back(touches(distance, material) ? 1 : 0);
  }
  return {std::move(gap), std::move(contact)};
}

}  // namespace loosefit

#pragma once
#include <vector>

#include "loosefit/fabric/material.h"
#include "loosefit/maps/performance_map.h"
#include "loosefit/maps/worn_garment.h"

namespace loosefit {

/// Distance from the cloth's inner face to the skin [m], where the middle surface is `distance`
/// away: half the thickness less, not below zero (docs/theory/sensor_metrics.md 4). The drape rests
/// cloth at half its thickness, so cloth that lies on the skin has gap 0.
double gap_of(double distance, const Material& material);

/// Whether that gap counts as contact: not above contact_tolerance(material) (maps/pressure.h).
bool touches(double gap, const Material& material);

/// Arrays gap_mm, and contact: 1 where the vertex touches, else 0; its area mean is the contact
/// ratio of the garment.
std::vector<PerformanceMap> gap_maps(const WornGarment& worn, const Material& material);

}  // namespace loosefit

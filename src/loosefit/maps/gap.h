#pragma once
#include "loosefit/fabric/material.h"

namespace loosefit::maps {

/// Distance from the cloth's inner face to the skin [m], where the middle surface is `distance`
/// away: half the thickness less, not below zero (docs/theory/sensor_metrics.md 4). The drape rests
/// cloth at half its thickness, so cloth that lies on the skin has gap 0.
double gap_of(double distance, const fabric::Material& material);

/// Whether that gap counts as contact: not above contact_tolerance(material) (maps/pressure.h).
bool touches(double gap, const fabric::Material& material);

}  // namespace loosefit::maps

#pragma once
#include <vector>

#include "loosefit/maps/map_definition.h"

namespace loosefit::placement {

/// What a sensor reads of one array in one state.
struct FootprintReading {
  const maps::MapDefinition* map = nullptr;
  const maps::MapArray* array = nullptr;
  maps::OverFootprint over = maps::OverFootprint::mean;
  maps::ReadOrientation rigid = nullptr;  ///< of OverFootprint::rigid
};

/// All that the metrics of the catalogue need, each once, in its order.
const std::vector<FootprintReading>& footprint_readings();

/// Index into footprint_readings() of an array and how it is summed up over the footprint.
/// \throws Error when no metric of the catalogue is made of it.
int footprint_reading(const std::string& array,
                      maps::OverFootprint over = maps::OverFootprint::mean,
                      maps::ReadOrientation rigid = nullptr);

/// A metric of the catalogue (maps/catalogue.h) and what it is made of.
struct CatalogueMetric {
  const maps::SiteMetric* metric = nullptr;
  const maps::MapArray* array = nullptr;
  int reading = -1;  ///< index into footprint_readings(); −1: made of the rotations of all states
};

/// All metrics that measured sensors have, in the order of the catalogue.
const std::vector<CatalogueMetric>& catalogue_metrics();

/// What must have been simulated for it: "several postures", "several donnings" or nothing.
const char* needs(maps::OverStates states);

}  // namespace loosefit::placement

#pragma once
#include <map>
#include <optional>
#include <vector>

#include "loosefit/drape/drape.h"
#include "loosefit/garment/hierarchy.h"
#include "loosefit/maps/body_load.h"
#include "loosefit/maps/contact_share.h"
#include "loosefit/maps/girth.h"
#include "loosefit/maps/performance_map.h"
#include "loosefit/maps/pressure.h"
#include "loosefit/maps/statistics.h"
#include "loosefit/maps/strain_range.h"
#include "loosefit/maps/worn_garment.h"
#include "loosefit/maps/wrinkle_direction.h"
#include "loosefit/pipeline/case_pattern.h"

namespace loosefit::pipeline {

/// One map with its summary over the garment and per body region.
struct CaseMap {
  maps::PerformanceMap map;
  maps::MapStatistics overall;
  std::map<body::Region, maps::MapStatistics> regional;
};

/// The map of that array; nullptr where it was not made.
const CaseMap* find_map(const std::vector<CaseMap>& maps, const std::string& array);

/// Contact pressure of one garment: always made, the map "pressure" only shows it.
struct CasePressure {
  maps::PressureField field;  ///< empty when the drape does not know its forces
  maps::PressureAgreement overall;
  std::map<body::Region, maps::PressureAgreement> regional;  ///< where the garment touches
  maps::ContactShare contact_share;
};

/// Stage "maps" of one garment.
struct CaseMaps {
  maps::WornGarment worn;
  std::vector<CaseMap> maps;
  CasePressure pressure;
  maps::GarmentGirth chest;  ///< cut through the torso at the wearer's chest level
  std::map<body::Region, maps::WrinkleDirection> wrinkles;
  std::optional<maps::BodyLoad> load;  ///< absent when the drape does not know its forces
  maps::StrainRange strain_range;
};

/// One garment of a case, from its pattern to its maps. Lists begin with the innermost garment.
struct CaseGarment {
  CasePattern pattern;
  garment::GarmentHierarchy hierarchy;
  drape::Drape drape;  ///< in the reference state; certificate and report are those of all garments
  CaseMaps maps;
  const garment::Garment& mesh() const { return hierarchy.finest(); }
};

}  // namespace loosefit::pipeline

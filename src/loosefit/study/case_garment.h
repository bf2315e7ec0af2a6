#pragma once
#include <map>
#include <vector>

#include "loosefit/drape/drape.h"
#include "loosefit/garment/hierarchy.h"
#include "loosefit/maps/girth.h"
#include "loosefit/maps/performance_map.h"
#include "loosefit/maps/pressure.h"
#include "loosefit/maps/statistics.h"
#include "loosefit/maps/worn_garment.h"
#include "loosefit/maps/wrinkle_direction.h"
#include "loosefit/study/case_pattern.h"

namespace loosefit {

/// One map with its summary over the garment and per body region.
struct CaseMap {
  PerformanceMap map;
  MapStatistics overall;
  std::map<Region, MapStatistics> regional;
};

/// Contact pressure of one garment: always made, the map "pressure" only shows it.
struct CasePressure {
  PressureField field;  ///< empty when the drape does not know its forces
  PressureAgreement overall;
  std::map<Region, PressureAgreement> regional;  ///< where the garment touches
};

/// Stage "maps" of one garment.
struct CaseMaps {
  WornGarment worn;
  std::vector<CaseMap> maps;
  CasePressure pressure;
  GarmentGirth chest;  ///< cut through the torso at the wearer's chest level
  std::map<Region, WrinkleDirection> wrinkles;
};

/// One garment of a case, from its pattern to its maps. Lists begin with the innermost garment.
struct CaseGarment {
  CasePattern pattern;
  GarmentHierarchy hierarchy;
  Drape drape;  ///< in the reference state; certificate and report are those of all garments
  CaseMaps maps;
  const Garment& mesh() const { return hierarchy.finest(); }
};

}  // namespace loosefit

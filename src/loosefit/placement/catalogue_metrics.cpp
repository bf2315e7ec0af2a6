#include "loosefit/placement/catalogue_metrics.h"

#include "loosefit/base/error.h"
#include "loosefit/maps/catalogue.h"

namespace loosefit::placement {
namespace {

/// Errors compare the rotations of two states: no state has a value of its own.
bool compares_states(maps::OverStates states) {
  switch (states) {
    case maps::OverStates::error_rms:
    case maps::OverStates::error_p95:
    case maps::OverStates::error_of_donnings:
    case maps::OverStates::turn_across:
    case maps::OverStates::turn_along:
    case maps::OverStates::turn_normal:
      return true;
    default:
      return false;
  }
}

/// How a footprint that counts as one rigid piece is read.
maps::ReadOrientation rigid_reading(const maps::MapArray& array, const maps::SiteMetric& metric) {
  if (metric.footprint != maps::OverFootprint::rigid) return nullptr;
  return metric.rigid ? metric.rigid : array.rigid;
}

int find(const std::vector<FootprintReading>& readings, const std::string& array,
         maps::OverFootprint over, maps::ReadOrientation rigid) {
  for (std::size_t i = 0; i < readings.size(); ++i)
    if (readings[i].array->style.array == array && readings[i].over == over &&
        readings[i].rigid == rigid)
      return static_cast<int>(i);
  return -1;
}

}  // namespace

const std::vector<FootprintReading>& footprint_readings() {
  static const std::vector<FootprintReading> kReadings = [] {
    std::vector<FootprintReading> readings;
    for (const maps::MapDefinition& map : maps::map_catalogue())
      for (const maps::MapArray& array : map.arrays)
        for (const maps::SiteMetric& metric : array.metrics) {
          const maps::ReadOrientation rigid = rigid_reading(array, metric);
          if (!compares_states(metric.states) &&
              find(readings, array.style.array, metric.footprint, rigid) < 0)
            readings.push_back({&map, &array, metric.footprint, rigid});
        }
    return readings;
  }();
  return kReadings;
}

int footprint_reading(const std::string& array, maps::OverFootprint over,
                      maps::ReadOrientation rigid) {
  const int index = find(footprint_readings(), array, over, rigid);
  if (index < 0) throw Error("no metric of a site is made of the array " + array);
  return index;
}

const std::vector<CatalogueMetric>& catalogue_metrics() {
  static const std::vector<CatalogueMetric> kMetrics = [] {
    std::vector<CatalogueMetric> metrics;
    for (const maps::MapDefinition& map : maps::map_catalogue())
      for (const maps::MapArray& array : map.arrays)
        for (const maps::SiteMetric& metric : array.metrics)
          metrics.push_back({&metric, &array,
                             compares_states(metric.states)
                                 ? -1
                                 : footprint_reading(array.style.array, metric.footprint,
                                                     rigid_reading(array, metric))});
    return metrics;
  }();
  return kMetrics;
}

const char* needs(maps::OverStates states) {
  switch (states) {
    case maps::OverStates::swing:
    case maps::OverStates::least_posture:
    case maps::OverStates::contact_duty:
    case maps::OverStates::greatest_change:
    case maps::OverStates::error_rms:
    case maps::OverStates::error_p95:
    case maps::OverStates::turn_across:
    case maps::OverStates::turn_along:
    case maps::OverStates::turn_normal:
      return "several postures";
    case maps::OverStates::error_of_donnings:
      return "several donnings";
    default:
      return "";
  }
}

}  // namespace loosefit::placement

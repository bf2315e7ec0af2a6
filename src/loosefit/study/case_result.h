#pragma once
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "loosefit/base/stage_clock.h"
#include "loosefit/drape/drape.h"
#include "loosefit/garment/hierarchy.h"
#include "loosefit/io/scenario.h"
#include "loosefit/maps/compute_maps.h"
#include "loosefit/maps/girth.h"
#include "loosefit/maps/statistics.h"
#include "loosefit/maps/wrinkle_direction.h"
#include "loosefit/placement/sites.h"
#include "loosefit/study/case_body.h"
#include "loosefit/study/case_pattern.h"

namespace loosefit {

/// One map with its summary over the garment and per body region.
struct CaseMap {
  PerformanceMap map;
  MapStatistics overall;
  std::map<Region, MapStatistics> regional;
};

/// Contact pressure of one case: always made, the map "pressure" only shows it.
struct CasePressure {
  PressureField field;  ///< empty when the drape does not know its forces
  PressureAgreement overall;
  std::map<Region, PressureAgreement> regional;  ///< where the garment touches
};

/// Stage "maps".
struct CaseMaps {
  WornGarment worn;
  std::vector<CaseMap> maps;
  CasePressure pressure;
  GarmentGirth chest;  ///< cut through the torso at the wearer's chest level
  std::map<Region, WrinkleDirection> wrinkles;
};

/// A garment worn under the one that is studied.
struct CaseUnder {
  CasePattern pattern;
  GarmentHierarchy garment;
  Drape drape;    ///< its certificate is that of all garments
  CaseMaps maps;  ///< the same maps as of the studied garment
  const Garment& mesh() const { return garment.finest(); }
};

/// Spread of one number over the repeats of a case.
struct Spread {
  double mean = 0, deviation = 0;  ///< sample standard deviation
  int count = 0;
};

/// How the garment was put on for one donning.
struct CaseDonning {
  Vec3 shift = Vec3::Zero();  ///< [m]
  double twist = 0;           ///< [rad]
  double friction = 1;        ///< share of the material's coefficients
};

/// The garment in one more posture or after one more donning.
struct CaseState {
  int posture = 0, donning = 0;  ///< indices into the case's postures and donnings
  std::string name;              ///< of the posture
  Drape drape;
  std::vector<Drape> under = {};  ///< of the garments under it, the innermost first
  double seconds = 0;             ///< to drape it
  std::string left_out = {};      ///< why there is no drape to speak of; else empty
  /// Stage "maps", of a settled drape.
  WornGarment worn = {};
  PressureField pressure = {};
  /// In the reference posture the maps of the case; else slip against it in the same donning.
  std::vector<CaseMap> maps = {};
  std::map<Region, WrinkleDirection> wrinkles = {};
  std::vector<Site> sites = {};  ///< the case's sites in this drape; reference posture only
  bool counts() const { return left_out.empty() && drape.certificate.holds(); }
};

/// A case worn in several postures, after several donnings.
struct CaseWear {
  std::vector<std::string> postures;  ///< the first is that of the case's own drape and maps
  std::vector<std::shared_ptr<const Body>> bodies;  ///< per posture; empty without states
  /// Per posture, somebody who has been led into it from rest and into no other; null for the
  /// first.
  std::vector<std::shared_ptr<const SoftBody>> wearers;
  std::vector<CaseDonning> donnings;  ///< the first is undisturbed
  /// All but the first posture of the first donning, which is the case's own drape.
  std::vector<CaseState> states;
};

/// Everything one case yields, stage by stage. A drape that is not settled or not worn is sealed:
/// `maps` and `sites` stay empty unless they were asked for all the same.
struct CaseResult {
  Scenario scenario;
  CaseBody body;
  CasePattern pattern;
  GarmentHierarchy garment;
  Drape drape;
  CaseMaps maps;
  std::vector<CaseUnder> under;  ///< the innermost first
  CaseWear wear;                 ///< empty for one posture and one donning
  std::vector<Site> sites;
  std::vector<UncoveredSite> uncovered_sites;
  /// Only with repeats > 1: key of summary.json ("maps.distance_mm.area_mean") → spread over all
  /// drapes that settled, of what each of them has.
  std::map<std::string, Spread> repeats;
  std::vector<std::string> repeat_warnings;  ///< of the drapes from other starts
  std::vector<StageClock::Entry> seconds;    ///< per stage, in order
  double peak_memory_mb = 0;
  std::vector<std::string> warnings;

  bool sealed() const { return !drape.certificate.holds() && maps.maps.empty(); }
  const Garment& mesh() const { return garment.finest(); }
};

}  // namespace loosefit

#pragma once
#include <map>
#include <string>
#include <vector>

#include "loosefit/base/check.h"
#include "loosefit/pipeline/case_garment.h"
#include "loosefit/placement/sites.h"

namespace loosefit::pipeline {

/// Names one drape of a case by its posture and its donning (indices into CaseWear). The reference
/// state is the case's own drape: the first donning in the reference posture, in which the maps are
/// made and sensors are calibrated.
struct StateId {
  static constexpr int kReferencePosture = 0, kFirstDonning = 0;
  int posture = kReferencePosture, donning = kFirstDonning;

  bool in_reference_posture() const { return posture == kReferencePosture; }
  bool in_first_donning() const { return donning == kFirstDonning; }
  bool operator==(const StateId&) const = default;
};

/// Stage "maps" of one state, of the studied garment.
struct StateMaps {
  maps::WornGarment worn;
  maps::PressureField pressure;
  /// The maps of the case; in another posture then slip since the reference of the donning.
  std::vector<CaseMap> maps;
  std::map<body::Region, maps::WrinkleDirection> wrinkles;
};

/// The garments in one more posture or after one more donning.
struct CaseState {
  StateId id;
  std::string name;                         ///< of the posture
  std::vector<drape::Drape> drapes = {};    ///< one per garment, the innermost first; empty: none
  double seconds = 0;                       ///< to drape it
  std::string left_out = {};                ///< why there is no drape to speak of; else empty
  StateMaps maps = {};                      ///< of a drape that counts
  std::vector<placement::Site> sites = {};  ///< the case's sites in this drape, if it counts

  bool draped() const { return !drapes.empty(); }
  /// Of the garment that is studied; certificate and report are those of all. \pre draped()
  const drape::Drape& drape() const {
    LOOSEFIT_ASSERT(draped());
    return drapes.back();
  }
  /// Holds for no drape when there is none.
  drape::Certificate certificate() const {
    return draped() ? drape().certificate : drape::Certificate{};
  }
  bool counts() const { return left_out.empty() && certificate().holds(); }
};

/// "sitting", and with several donnings "sitting of donning 2".
std::string state_label(const CaseState& state, std::size_t donnings);

}  // namespace loosefit::pipeline

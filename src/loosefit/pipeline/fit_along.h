#pragma once
#include <optional>
#include <string>
#include <vector>

#include "loosefit/body/body.h"
#include "loosefit/kinds/fit_stations.h"

namespace loosefit::pipeline {

/// How a garment fits at one of many levels along trunk and arm.
struct StationFit {
  std::string limb;    ///< "trunk" or "arm"
  std::string place;   ///< what is there: "chest", "waist", "hip", "upper arm", "elbow", …
  double along = 0;    ///< as FitStation::along [m]
  double garment = 0;  ///< girth of the flat pieces [m]
  double body = 0;     ///< tape girth of the body [m]
  std::optional<double> asked;  ///< mobility asked for; absent: nothing was
  double cut() const { return garment / body - 1; }
};

/// The girths of the body at the stations of a pattern. Trunk: level sections where a tape down the
/// back is as long as the station is far down; where they would cut the arms too, and below the
/// crotch, there is no station. Arm: sections square to it, the one at the elbow halves its bend;
/// nor is there one where they would cut the trunk too. The larger of both arms counts; people who
/// lack a part of one have the other. \param body arms apart; its joints,
/// landmarks and measures are read, and what of them is missing leaves out the limb.
std::vector<StationFit> fit_along(const std::vector<kinds::FitStation>& stations,
                                  const body::Body& body);

}  // namespace loosefit::pipeline

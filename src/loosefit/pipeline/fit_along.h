#pragma once
#include <optional>
#include <string>
#include <vector>

#include "loosefit/body/body.h"
#include "loosefit/kinds/fit_stations.h"
#include "loosefit/kinds/girth_line.h"

namespace loosefit::pipeline {

/// How a garment fits at one of many levels along trunk, arm or leg.
struct StationFit {
  std::string limb;    ///< "trunk", "arm" or "leg"
  std::string place;   ///< what is there: "chest", "waist", "hip", "upper arm", "elbow", …
  double along = 0;    ///< as FitStation::along [m]
  double garment = 0;  ///< girth of the flat pieces [m]
  double body = 0;     ///< tape girth of the body [m]
  std::optional<double> asked;  ///< mobility asked for; absent: nothing was
  std::vector<kinds::StationLine> lines = {};  ///< as FitStation::lines
  double cut() const { return garment / body - 1; }
};

/// The girths of the body at the stations of a pattern; where the body has none there is no
/// station. \param girths of that body (kinds/girths_along.h)
std::vector<StationFit> fit_along(const std::vector<kinds::FitStation>& stations,
                                  const body::Body& body, const kinds::GirthsAlong& girths);

}  // namespace loosefit::pipeline

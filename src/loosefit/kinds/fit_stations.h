#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "loosefit/pattern/pattern.h"

namespace loosefit::kinds {

/// A level line on a piece: where it is cut for a station.
struct StationLine {
  std::string part;  ///< Panel::part
  double y = 0;      ///< in the piece [m]
};

/// Girth of a garment at one of many levels along trunk, arm or leg, a fixed step apart.
struct FitStation {
  std::string limb;  ///< "trunk", "arm" or "leg"
  /// Trunk: down the back from the high point shoulder. Arm: down from the shoulder point. Leg: down
  /// from the crotch [m].
  double along = 0;
  double garment = 0;           ///< on the flat pieces [m]
  std::optional<double> asked;  ///< mobility there, even between the levels of fit; absent: none
  std::vector<StationLine> lines = {};  ///< whose widths the girth is; of the left limb
};

/// Step between two stations [m].
inline constexpr double kStationStep = 0.02;

/// Mobility asked for at a level of a limb.
struct AskedMobility {
  double along = 0, mobility = 0;
};

/// Value between the asked levels; beyond their ends the nearest one. Empty without any.
std::optional<double> mobility_at(const std::vector<AskedMobility>& asked, double along);

/// Width of a panel along a level line of its own, y = const; parts beside each other are summed
/// [m]. 0 where there is none.
double width_at(const pattern::Panel& panel, double y);

/// Stations from `first` to `last` along a limb, every kStationStep at round multiples of it, where
/// each of `panels` has a width. `y_of`: level line in the panels for a place along the limb.
std::vector<FitStation> stations_along(const std::string& limb,
                                       const std::vector<const pattern::Panel*>& panels,
                                       double first, double last,
                                       const std::function<double(double)>& y_of,
                                       const std::vector<AskedMobility>& asked);

}  // namespace loosefit::kinds

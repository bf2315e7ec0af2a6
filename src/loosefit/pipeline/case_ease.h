#pragma once
#include <optional>
#include <string>
#include <vector>

#include "loosefit/pipeline/case_result.h"

namespace loosefit::pipeline {

/// Cut ease (of the flat pieces) and asked ease of a garment at one station, as garment girth /
/// body girth − 1.
struct StationEase {
  std::string name;                  ///< "chest", "sleeve", "sleeve at the forearm", …
  double cut = 0;                    ///< of the flat pieces on this body [–]
  std::optional<double> asked = {};  ///< [–]; absent: nobody asked for one there
  bool drawn_in = false;             ///< tight by the draft itself, as a waistband is
  double body = 0;                   ///< girth of the body [m]; 0: not known
  /// As worn: the way of the yarns round the body over its girth − 1 [–]; absent: not draped, or no
  /// station there.
  std::optional<double> worn = {};
};

/// All stations whose body girth is known: the levels of fit, and the tightest near each place
/// along trunk and arm. Those that have a key of the kind were asked for: by the scenario, or by
/// what the kind usually has. A fixed size and a pattern file ask for nothing.
std::vector<StationEase> station_eases(const CasePattern& pattern,
                                       const scenario::GarmentSpec& spec);
/// The same with the eases as worn.
std::vector<StationEase> station_eases(const CaseGarment& garment,
                                       const scenario::GarmentSpec& spec);

/// The one with the least ease; nothing where none is known.
std::optional<StationEase> least_cut_ease(const std::vector<StationEase>& stations);

/// Share of the asked ease below which a station counts as not cut as asked [–]: 15 % that come out
/// as less than 10 %.
inline constexpr double kCutShare = 2.0 / 3.0;
/// Normal force in weights of the garment beyond which it is not loose [–]. Of loose
/// shirts what is free of the arms is 2 to 5 weights at 10 mm and up to 10 at 20 mm edges; shirts
/// caught on the forearms press with 20 and more.
inline constexpr double kLooseWeights = 10;

/// The same of a garment of which nobody asked how loose it is, a fixed size or a pattern file [–]:
/// published tops and skirts that fit hang with 2 to 23 weights, such as are too small with 100 and
/// more; compression wear presses with as many, and is then told for what it is.
inline constexpr double kHeldWeights = 30;

/// Whether all eases that were asked for, at least one, are loose, and nothing is drawn in.
bool is_asked_loose(const std::vector<StationEase>& stations);

/// Pressure of a tube that is stretched from its cut girth to that of the body, by Laplace's law
/// with the stiffness along the weft [Pa]: the pull per metre of height over the mean radius. 0
/// where it is not cut narrower, or where the girth of the body is not known.
double pressure_when_closed(const StationEase& station, const fabric::Material& material);

/// In words: stations that are not cut as they were asked for, and a garment that presses with many
/// times its weight although it was asked to be loose, or although nobody asked for anything; with
/// the station that would press most if it were closed round the body, of those that nobody asked
/// for.
std::vector<std::string> ease_warnings(const std::vector<StationEase>& stations,
                                       const std::optional<maps::BodyLoad>& load,
                                       const fabric::Material& material = {});

/// In words: cloth that is strained beyond what its constants were measured over; one line at most.
std::vector<std::string> beyond_range_warnings(const maps::StrainRange& range,
                                               const scenario::MaterialCard& card);

/// Largest elongation along warp or weft of which no range is stated [–]; 0 where both are.
double largest_unstated(const maps::StrainRange& range);

/// In words: warp and weft of which no range is stated, where they are strained so far that it
/// would matter.
std::vector<std::string> unstated_strain_warnings(const maps::StrainRange& range);

/// Both.
std::vector<std::string> strain_range_warnings(const maps::StrainRange& range,
                                               const scenario::MaterialCard& card);

/// In words: skin that is pressed beyond comfort (the last of maps::kPressureClasses) over more
/// than a few square centimetres, and where; one line at most. What lies between an arm and the
/// trunk is a hidden fold more often than a tight place, and is told apart by the load.
std::vector<std::string> comfort_warnings(const maps::PressureField& field,
                                          const std::vector<body::Region>& regions);

}  // namespace loosefit::pipeline

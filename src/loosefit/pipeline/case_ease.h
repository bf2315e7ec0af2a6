#pragma once
#include <optional>
#include <string>
#include <vector>

#include "loosefit/pipeline/case_result.h"

namespace loosefit::pipeline {

/// Cut ease (of the flat pieces) and asked ease of a garment at one station, as garment girth /
/// body girth − 1.
struct StationEase {
  std::string name;             ///< "chest", "sleeve", "sleeve at the forearm", …
  double cut = 0;               ///< of the flat pieces on this body [–]
  std::optional<double> asked;  ///< [–]; absent: nobody asked for one there
  bool drawn_in = false;        ///< tight by the draft itself, as a waistband is
};

/// All stations whose body girth is known: the levels of fit, and the tightest near each place
/// along trunk and arm. Those that have a key of the kind were asked for: by the scenario, or by
/// what the kind usually has. A fixed size and a pattern file ask for nothing.
std::vector<StationEase> station_eases(const CasePattern& pattern,
                                       const scenario::GarmentSpec& spec);

/// The one with the least ease; nothing where none is known.
std::optional<StationEase> least_cut_ease(const std::vector<StationEase>& stations);

/// Ease from which on a garment is meant to be loose [–].
inline constexpr double kLooseEase = 0.05;
/// Share of the asked ease below which a station counts as not cut as asked [–]: 15 % that come out
/// as less than 10 %.
inline constexpr double kCutShare = 2.0 / 3.0;
/// Normal force in weights of the garment beyond which it is not loose [–]. Of loose
/// shirts what is free of the arms is 2 to 5 weights at 10 mm and up to 10 at 20 mm edges; shirts
/// caught on the forearms press with 20 and more.
inline constexpr double kLooseWeights = 10;

/// Whether all eases that were asked for, at least one, are loose, and nothing is drawn in.
bool is_asked_loose(const std::vector<StationEase>& stations);

/// In words: stations that are not cut as they were asked for, and a garment that was asked to be
/// loose but presses with many times its weight.
std::vector<std::string> ease_warnings(const std::vector<StationEase>& stations,
                                       const std::optional<maps::BodyLoad>& load);

/// In words: cloth that is strained beyond what its constants were measured over.
std::vector<std::string> strain_range_warnings(const maps::StrainRange& range,
                                               const scenario::MaterialCard& card);

/// In words: skin that is pressed beyond comfort (the last of maps::kPressureClasses) over more
/// than a few square centimetres, and where; one line at most. What lies between an arm and the
/// trunk is a hidden fold more often than a tight place, and is told apart by the load.
std::vector<std::string> comfort_warnings(const CaseMaps& maps);

}  // namespace loosefit::pipeline

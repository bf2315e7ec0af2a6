#pragma once
#include <string>
#include <vector>

#include "loosefit/study/case_result.h"

// The parts of run_case that are more than one call.
namespace loosefit {

/// What the drape stage needs of [simulation]; `repeat` shifts the seed.
DrapeOptions drape_options(const ScenarioSimulation& simulation, int repeat = 0);

/// Stage "maps" for the drape of `result`. \throws Error if it is sealed and not allowed.
CaseMaps make_maps(const CaseResult& result, bool allow_unsettled);

/// The same of a garment under the studied one.
CaseMaps make_under_maps(const CaseResult& result, int layer, bool allow_unsettled);

/// One map with its statistics.
CaseMap summed_up(PerformanceMap map, const WornGarment& worn);

/// The same of all garments into `result`, and the maps of all its postures and donnings: in the
/// reference posture the same maps, in the others slip, in all the wrinkles; and the slip and
/// calibrated orientation error over the postures of the first donning beside the other maps.
void add_maps(CaseResult& result, bool allow_unsettled);

/// Stage "placement": preset sites and those of the scenario, with what the maps say there; those
/// that the garment does not cover into `uncovered`.
/// \throws InvalidInput naming a site whose panel or landmark is unknown.
std::vector<Site> make_sites(const CaseResult& result,
                             std::vector<UncoveredSite>* uncovered = nullptr);

/// The same into result.sites, and what these sensors, sewn where they are, meet in the other
/// donnings.
void add_sites(CaseResult& result);

/// The sensors of an earlier drape of the same garment in the drape of `result`: they stay where
/// they are sewn, also those that were found by a landmark.
std::vector<Site> same_sites(const CaseResult& result, const std::vector<Site>& sites);

/// Stage "repeats": drapes again from other starts, `at_once` side by side, as often as the
/// scenario's `repeats` asks beyond the first, and gathers the spread of every area mean and every
/// site value in result.repeats. A repeat that does not settle or is not worn is left out and named
/// in result.repeat_warnings; there is no spread of fewer than two.
void repeat_drapes(CaseResult& result, int at_once, Progress& progress);

/// Drops spreads of maps and sites that `result`, an earlier output taken up again, has not now.
void keep_known_repeats(CaseResult& result);

/// Everything the user should know, in stage order.
std::vector<std::string> collected_warnings(const CaseResult& result);

}  // namespace loosefit

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

/// Stage "placement": preset sites and those of the scenario, with what the maps say there.
/// \throws InvalidInput naming a site whose panel or landmark is unknown.
std::vector<Site> make_sites(const CaseResult& result);

/// The same into result.sites, and what these sensors, sewn where they are, meet in the other
/// donnings.
void add_sites(CaseResult& result);

/// The sensors of an earlier drape of the same garment in the drape of `result`: they stay where
/// they are sewn, also those that were found by a landmark.
std::vector<Site> same_sites(const CaseResult& result, const std::vector<Site>& sites);

/// Stage "repeats": drapes again from other starts, side by side, as often as the scenario's
/// `repeats` asks beyond the first, and gathers the spread of every area mean and every site value
/// in result.repeats. A repeat that does not settle is left out of the spread and named in the
/// warnings.
void repeat_drapes(CaseResult& result, Progress& progress);

/// Everything the user should know, in stage order.
std::vector<std::string> collected_warnings(const CaseResult& result);

}  // namespace loosefit

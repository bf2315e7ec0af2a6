#include "loosefit/pipeline/run_case.h"

#include "loosefit/base/resources.h"
#include "loosefit/base/stage_clock.h"
#include "loosefit/io/scenario.h"
#include "loosefit/io/scenario_place.h"
#include "loosefit/pipeline/case_lines.h"
#include "loosefit/pipeline/case_sites.h"
#include "loosefit/pipeline/case_warnings.h"
#include "loosefit/pipeline/check_worn.h"
#include "loosefit/pipeline/drape_side_by_side.h"
#include "loosefit/pipeline/drape_states.h"
#include "loosefit/pipeline/garment_layers.h"
#include "loosefit/pipeline/map_case.h"
#include "loosefit/pipeline/prepare_case.h"
#include "loosefit/pipeline/repeat_drapes.h"
#include "loosefit/pipeline/simulation_options.h"
#include "loosefit/pipeline/wear_states.h"

namespace loosefit::pipeline {

CaseResult run_case(const scenario::Scenario& scenario, Progress& progress,
                    const RunOptions& options) try {
  const ThreadLimit threads(scenario.simulation.threads);
  StageClock clock(progress);

  CaseResult result = prepare_case(scenario, clock);  // body, pattern, garment

  int at_once = 1;
  {
    const CaseDonning how = planned_donnings(scenario.donning).front();
    drape::DrapeOptions settling = drape_options(scenario.simulation);
    settling.start_shift = how.shift;
    settling.start_twist = how.twist;
    settling.others_follow = plan_wear(result.scenario).postures.size() > 1;
    const auto session = std::make_shared<drape::DrapeSession>(
        cloth_layers(result.scenario, result.garments, how.friction), settling, clock);
    const drape::Drape drape =
        put_on(*session, result.body, how.movements, &scenario);  // dress, settle
    result.take_drapes(check_worn(split_drape(drape, result.scenario, result.garments),
                                  result.garments, result.scenario, result.body.body));
    at_once = drapes_at_once();
    result.wear = drape_states(result, session, at_once, clock);  // postures, donnings
  }

  const bool open = result.certificate().holds() || options.allow_unsettled;
  if (open && !options.only_drape) {
    clock.stage("maps");
    result.take_maps(map_case(result, options.allow_unsettled));

    clock.stage("placement");
    result.take_sites(make_sites(result));
    result.take_lines(measure_lines(result));

    result.repeats = repeat_drapes(result, at_once, clock);  // repeats
  }
  clock.stop();
  result.seconds = clock.entries();
  result.peak_memory_mb = peak_memory_mb();
  result.warnings = case_warnings(result);
  return result;
} catch (const InvalidInput& error) {
  throw io::in_scenario(error, scenario);
}

}  // namespace loosefit::pipeline

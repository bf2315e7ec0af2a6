#include "loosefit/pipeline/run_case.h"

#include <utility>

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
#include "loosefit/pipeline/map_case.h"
#include "loosefit/pipeline/prepare_case.h"
#include "loosefit/pipeline/put_on_garments.h"
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
    PutOn first = put_on_garments(result.scenario, result.garments, result.body,
                                  planned_donnings(scenario.donning).front(),
                                  drape_options(scenario.simulation),
                                  clock);  // dress, settle
    result.take_drapes(
        check_worn(std::move(first.drapes), result.garments, result.scenario, result.body.body));
    doubt_putting_on(result);
    at_once = drapes_at_once();
    result.wear = drape_states(result, std::move(first.session), at_once,
                               clock);  // postures, donnings
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

#include "loosefit/study/run_case.h"

#include <tbb/global_control.h>

#include <optional>

#include "loosefit/base/resources.h"
#include "loosefit/study/case_boards.h"
#include "loosefit/study/case_layers.h"
#include "loosefit/study/case_stages.h"
#include "loosefit/study/check_worn.h"
#include "loosefit/study/drape_states.h"
#include "loosefit/study/drapes_at_once.h"

namespace loosefit {

CaseResult run_case(const Scenario& scenario, Progress& progress, const RunOptions& options) try {
  StageClock clock(progress);
  std::optional<tbb::global_control> threads;
  if (scenario.simulation.threads > 0)
    threads.emplace(tbb::global_control::max_allowed_parallelism, scenario.simulation.threads);
  CaseResult result;
  result.scenario = scenario;

  clock.stage("body");
  result.body = make_body(scenario.body);

  clock.stage("pattern");
  result.under = make_under_patterns(scenario, result.body.body);
  result.pattern = make_pattern(scenario.studied().spec, result.body.body);

  clock.stage("garment");
  place_boards(result, clock);
  clock.stage("garment");
  result.garment =
      build_hierarchy(result.pattern.pattern, scenario.simulation.edge_length,
                      scenario.studied().material.material, all_attachments(result.scenario));
  mesh_under(result, scenario.simulation.edge_length);
  check_sites(result.mesh(), result.body.body, scenario.sites);  // before the long part

  int at_once = 1;
  {
    const auto session = std::make_shared<DrapeSession>(cloth_layers(result),
                                                        drape_options(scenario.simulation), clock);
    take_drape(put_on(*session, result.body), result);  // dress, settle
    check_worn(result);
    at_once = drapes_at_once();
    drape_states(result, session, at_once, clock);  // postures, donnings
  }

  const bool open = result.drape.certificate.holds() || options.allow_unsettled;
  if (open && !options.only_drape) {
    clock.stage("maps");
    add_maps(result, options.allow_unsettled);

    clock.stage("placement");
    add_sites(result);
    warn_of_moved_boards(result);

    repeat_drapes(result, at_once, clock);
  }
  clock.stop();
  result.seconds = clock.entries();
  result.peak_memory_mb = peak_memory_mb();
  result.warnings = collected_warnings(result);
  return result;
} catch (const InvalidInput& error) {
  throw in_scenario(error, scenario);
}

}  // namespace loosefit

#include "loosefit/pipeline/prepare_case.h"

#include "loosefit/drape/cut_on_sleeves.h"
#include "loosefit/kinds/girths_along.h"
#include "loosefit/pipeline/case_lines.h"
#include "loosefit/pipeline/case_sewn_parts.h"
#include "loosefit/pipeline/check_worn.h"
#include "loosefit/pipeline/garment_layers.h"

namespace loosefit::pipeline {

CaseResult prepare_case(const scenario::Scenario& scenario, Progress& progress) {
  CaseResult result;
  result.scenario = scenario;

  progress.stage("body");
  result.body = make_body(scenario.body, &progress);

  progress.stage("pattern");
  std::vector<CasePattern> patterns = make_patterns(
      scenario, result.body.body, kinds::girths_along(result.body.path(0).body()));

  progress.stage("garment");
  SewnParts sewn = place_sewn_parts(scenario, result.body, patterns, progress);
  result.scenario.sites = std::move(sewn.sites);
  progress.stage("garment");  // after the stages of a first, coarse drape
  result.garments = mesh_garments(scenario, patterns, sewn.attachments);
  for (const CaseGarment& garment : result.garments)
    if (const auto angle =
            drape::cut_on_sleeve_angle(garment.mesh(), garment.pattern.pattern, result.body.body))
      widen(result.body, *angle);
  result.putting_on = judge_putting_on(result.garments, scenario, result.body.body);
  placement::check_sites(result.studied().mesh(), result.body.body,
                         scenario.sites);  // before the long part
  check_lines(result);
  return result;
}

}  // namespace loosefit::pipeline

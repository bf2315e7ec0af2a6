#include "loosefit/pipeline/case_result.h"

#include <utility>

#include "loosefit/base/check.h"

namespace loosefit::pipeline {

void CaseResult::take_drapes(std::vector<drape::Drape> drapes) {
  require(drapes.size() == garments.size(), "one drape per garment");
  for (std::size_t g = 0; g < garments.size(); ++g) garments[g].drape = std::move(drapes[g]);
}

void CaseResult::take_maps(MapStage made) {
  require(made.garments.size() == garments.size() && made.states.size() == wear.states.size(),
          "maps of every garment and every state");
  for (std::size_t g = 0; g < garments.size(); ++g) garments[g].maps = std::move(made.garments[g]);
  for (std::size_t s = 0; s < wear.states.size(); ++s)
    wear.states[s].maps = std::move(made.states[s]);
}

void CaseResult::take_sites(SiteStage made) {
  require(made.in_states.size() == wear.states.size(), "sites of every state");
  sites = std::move(made.sites);
  uncovered_sites = std::move(made.uncovered);
  for (std::size_t s = 0; s < wear.states.size(); ++s)
    wear.states[s].sites = std::move(made.in_states[s]);
}

void CaseResult::take_lines(LineStage made) {
  lines = std::move(made.lines);
  lines_left_out = std::move(made.left_out);
}

}  // namespace loosefit::pipeline

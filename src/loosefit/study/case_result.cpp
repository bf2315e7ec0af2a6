#include "loosefit/study/case_result.h"

#include <utility>

namespace loosefit {

void CaseResult::take_drapes(std::vector<Drape> drapes) {
  for (std::size_t g = 0; g < garments.size(); ++g) garments[g].drape = std::move(drapes.at(g));
}

void CaseResult::take_maps(MapStage made) {
  for (std::size_t g = 0; g < garments.size(); ++g)
    garments[g].maps = std::move(made.garments.at(g));
  for (std::size_t s = 0; s < wear.states.size(); ++s)
    wear.states[s].maps = std::move(made.states.at(s));
}

void CaseResult::take_sites(SiteStage made) {
  sites = std::move(made.sites);
  uncovered_sites = std::move(made.uncovered);
  for (std::size_t s = 0; s < wear.states.size(); ++s)
    wear.states[s].sites = std::move(made.in_states.at(s));
}

}  // namespace loosefit

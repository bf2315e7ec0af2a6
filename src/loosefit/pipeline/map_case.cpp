#include "loosefit/pipeline/map_case.h"

#include "loosefit/pipeline/garment_maps.h"
#include "loosefit/pipeline/state_maps.h"

namespace loosefit::pipeline {

MapStage map_case(const CaseResult& draped, bool allow_unsettled) {
  MapStage made;
  for (std::size_t g = 0; g < draped.garments.size(); ++g)
    made.garments.push_back(
        make_maps({draped.garments[g].mesh(), draped.garments[g].drape,
                   draped.scenario.garments[g].material.material, draped.body.body},
                  draped.scenario, allow_unsettled));
  CaseMaps& studied = made.garments.back();
  made.states = map_states(draped, studied.worn);
  for (CaseMap& map : posture_maps(draped, studied.worn, made.states))
    studied.maps.push_back(std::move(map));
  return made;
}

}  // namespace loosefit::pipeline

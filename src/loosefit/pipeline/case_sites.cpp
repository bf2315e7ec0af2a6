#include "loosefit/pipeline/case_sites.h"

#include "loosefit/pipeline/garment_maps.h"

namespace loosefit::pipeline {

SiteStage find_case_sites(const CaseResult& mapped) {
  const CaseGarment& garment = mapped.studied();
  SiteStage made;
  made.sites =
      placement::find_sites(garment.mesh(), garment.drape.positions, mapped.body.body,
                            garment.maps.worn, plain_maps(garment.maps.maps), mapped.scenario.sites,
                            mapped.scenario.output.preset_sites, &made.uncovered);
  return made;
}

SiteStage make_sites(const CaseResult& mapped) {
  SiteStage made = find_case_sites(mapped);
  for (const CaseState& state : mapped.wear.states) {
    std::vector<placement::Site>& here = made.in_states.emplace_back();
    if (state.id.in_reference_posture() && state.counts())
      here =
          placement::revisit_sites(made.sites, mapped.studied().mesh(), state.drape().positions,
                                   mapped.body.body, state.maps.worn, plain_maps(state.maps.maps));
  }
  return made;
}

}  // namespace loosefit::pipeline

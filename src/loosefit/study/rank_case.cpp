#include "loosefit/study/rank_case.h"

namespace loosefit {

RankingTable rank_case(const CaseResult& result, const RankingWish& wish) {
  const std::vector<WornState> states = {
      {0, 0, result.drape.positions, result.body.body, result.maps.worn,
       result.maps.pressure.field.empty() ? nullptr : &result.maps.pressure.field}};
  const SiteMeter meter(result.mesh(), result.scenario.material.material, states);
  return make_ranking(
      {result.mesh(), result.drape.positions, result.body.body, result.maps.worn, meter}, wish);
}

}  // namespace loosefit

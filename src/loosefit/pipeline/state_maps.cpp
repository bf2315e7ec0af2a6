#include "loosefit/pipeline/state_maps.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>

#include "loosefit/maps/compute_maps.h"
#include "loosefit/maps/orientation_error.h"
#include "loosefit/maps/skin_partner.h"
#include "loosefit/pipeline/garment_maps.h"

namespace loosefit::pipeline {
namespace {

/// Calls visit(i) for every state that counts, side by side. Isolated: what a state does in
/// parallel must not begin another one in between.
template <class Visit>
void for_each_that_counts(const std::vector<CaseState>& states, const Visit& visit) {
  tbb::parallel_for(std::size_t{0}, states.size(), [&](std::size_t i) {
    if (states[i].counts()) tbb::this_task_arena::isolate([&] { visit(i); });
  });
}

const char* const kSlipArray = "slip_mm";

std::vector<CaseMap> all_with_statistics(std::vector<maps::PerformanceMap> maps,
                                         const maps::WornGarment& worn) {
  std::vector<CaseMap> all;
  for (maps::PerformanceMap& map : maps) all.push_back(with_statistics(std::move(map), worn));
  return all;
}

/// The state of the same donning in the reference posture, against which slip is measured.
maps::DressedState reference_of(const StateId& id, const CaseResult& draped,
                                const maps::WornGarment& reference,
                                const std::vector<StateMaps>& made) {
  if (!id.in_first_donning()) {
    const std::vector<CaseState>& states = draped.wear.states;
    for (std::size_t i = 0; i < states.size(); ++i)
      if (states[i].id == StateId{StateId::kReferencePosture, id.donning} && states[i].counts())
        return {states[i].drape().positions, draped.body.body, made[i].worn};
  }
  return {draped.studied().drape.positions, draped.body.body, reference};
}

}  // namespace

std::vector<StateMaps> map_states(const CaseResult& draped, const maps::WornGarment& reference) {
  const scenario::Scenario& scenario = draped.scenario;
  const fabric::Material& material = scenario.studied().material.material;
  const garment::Garment& mesh = draped.studied().mesh();
  const std::vector<CaseState>& states = draped.wear.states;
  std::vector<StateMaps> all(states.size());

  // What each state tells by itself.
  for_each_that_counts(states, [&](std::size_t i) {
    const drape::Drape& drape = states[i].drape();
    const body::PosedBody& body = draped.body_in(states[i].id.posture);
    StateMaps& made = all[i];
    made.worn = maps::relate(mesh, drape.positions, body);
    if (!drape.body_normal_force.empty())
      made.pressure =
          maps::contact_pressure(mesh, drape, body, material, scenario.simulation.gravity);
    made.wrinkles = maps::regional_wrinkles(mesh, made.worn);
    made.maps = all_with_statistics(maps::compute_maps(mesh, drape, made.worn, scenario.output.maps,
                                                       {false, &made.pressure, &material}),
                                    made.worn);
  });

  // Slip against the reference posture of the same donning.
  for_each_that_counts(states, [&](std::size_t i) {
    const StateId& id = states[i].id;
    if (id.in_reference_posture()) return;
    const maps::DressedState now{states[i].drape().positions, draped.body_in(id.posture),
                                 all[i].worn};
    for (CaseMap& slip : all_with_statistics(
             maps::slip_maps(mesh, reference_of(id, draped, reference, all), now), all[i].worn))
      all[i].maps.push_back(std::move(slip));
  });
  return all;
}

std::vector<CaseMap> posture_maps(const CaseResult& draped, const maps::WornGarment& reference,
                                  const std::vector<StateMaps>& states) {
  std::vector<maps::DressedState> others;
  maps::PerformanceMap slip;
  for (std::size_t i = 0; i < states.size(); ++i) {
    const CaseState& state = draped.wear.states[i];
    if (!state.id.in_first_donning() || !state.counts()) continue;
    others.push_back({state.drape().positions, draped.body_in(state.id.posture), states[i].worn});
    const maps::PerformanceMap& here = find_map(states[i].maps, kSlipArray)->map;
    if (slip.values.empty()) {
      slip = here;
      slip.title = "Slip on the skin, greatest over postures";
      continue;
    }
    for (std::size_t v = 0; v < slip.values.size(); ++v)
      slip.values[v] = std::max(slip.values[v], here.values[v]);
  }
  if (others.empty()) return {};
  const maps::DressedState own{draped.studied().drape.positions, draped.body.body, reference};
  std::vector<maps::PerformanceMap> maps = {std::move(slip)};
  for (maps::PerformanceMap& map :
       maps::orientation_error_maps(draped.studied().mesh(), own, others))
    maps.push_back(std::move(map));
  return all_with_statistics(std::move(maps), reference);
}

}  // namespace loosefit::pipeline

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <cmath>
#include <limits>

#include "loosefit/maps/skin_partner.h"
#include "loosefit/study/case_stages.h"
#include "loosefit/study/wear_states.h"

namespace loosefit {
namespace {

/// Side by side. Isolated: what a state does in parallel must not begin another one in between.
template <class Visit>
void for_each_state(std::vector<CaseState>& states, const Visit& visit) {
  tbb::parallel_for(std::size_t{0}, states.size(), [&](std::size_t i) {
    tbb::this_task_arena::isolate([&] { visit(states[i]); });
  });
}

/// Slip and orientation error over the postures of the first donning, per vertex.
void add_posture_maps(CaseResult& result) {
  const DressedState reference{result.drape.positions, result.body.body, result.maps.worn};
  std::vector<DressedState> others;
  PerformanceMap slip;
  for (const CaseState& s : result.wear.states) {
    if (s.donning != 0 || !s.counts()) continue;
    others.push_back({s.drape.positions, *result.wear.bodies[s.posture], s.worn});
    const PerformanceMap& here = s.maps.front().map;
    if (slip.values.empty()) {
      slip = here;
      slip.title = "Slip on the skin, greatest over postures";
      continue;
    }
    for (std::size_t v = 0; v < slip.values.size(); ++v)
      slip.values[v] = std::max(slip.values[v], here.values[v]);
  }
  if (others.empty()) return;
  result.maps.maps.push_back(summed_up(std::move(slip), result.maps.worn));
  for (PerformanceMap& map : orientation_error_maps(result.mesh(), reference, others))
    result.maps.maps.push_back(summed_up(std::move(map), result.maps.worn));
}

}  // namespace

void map_states(CaseResult& result) {
  const Material& material = result.scenario.studied().material.material;
  const auto body_of = [&](const CaseState& s) -> const Body& {
    return s.posture == 0 ? result.body.body : *result.wear.bodies[s.posture];
  };
  auto& states = result.wear.states;
  for_each_state(states, [&](CaseState& s) {
    if (!s.counts()) return;
    s.worn = relate(result.mesh(), s.drape.positions, body_of(s));
    if (!s.drape.body_normal_force.empty())
      s.pressure = contact_pressure(result.mesh(), s.drape, body_of(s), material,
                                    result.scenario.simulation.gravity);
    s.wrinkles = regional_wrinkles(result.mesh(), s.worn);
    if (s.posture > 0) return;
    s.maps.clear();
    for (PerformanceMap& map :
         compute_maps(result.mesh(), s.drape, s.worn, result.scenario.output.maps,
                      {false, &s.pressure, &material}))
      s.maps.push_back(summed_up(std::move(map), s.worn));
  });
  for_each_state(states, [&](CaseState& s) {
    if (!s.counts() || s.posture == 0) return;
    const CaseState* own = nullptr;  // reference of a further donning
    for (const CaseState& other : states)
      if (other.donning == s.donning && other.posture == 0 && other.counts()) own = &other;
    const DressedState reference =
        s.donning == 0 ? DressedState{result.drape.positions, result.body.body, result.maps.worn}
                       : DressedState{own->drape.positions, result.body.body, own->worn};
    s.maps.clear();
    for (PerformanceMap& map :
         slip_maps(result.mesh(), reference, {s.drape.positions, body_of(s), s.worn}))
      s.maps.push_back(summed_up(std::move(map), s.worn));
  });
  add_posture_maps(result);
}

void add_maps(CaseResult& result, bool allow_unsettled) {
  result.maps = make_maps(result, allow_unsettled);
  for (std::size_t l = 0; l < result.under.size(); ++l)
    result.under[l].maps = make_under_maps(result, static_cast<int>(l), allow_unsettled);
  map_states(result);
}

}  // namespace loosefit

#include "loosefit/drape/phases/settle_levels.h"

#include <algorithm>
#include <limits>

#include "loosefit/drape/impact_zones.h"
#include "loosefit/drape/phases/follow_posture.h"
#include "loosefit/drape/worn_detail.h"

namespace loosefit::drape {
namespace {

/// GarmentHierarchy::parents of the next finer level, all layers numbered through.
std::vector<std::array<int, 2>> parents_of_next(const ClothState& state) {
  std::vector<std::array<int, 2>> all;
  for (int l = 0, shift = 0; l < state.layer_count(); shift += state.garment(l++).vertex_count)
    for (const auto& [a, b] : state.layers[l].garment->parents[state.level + 1])
      all.push_back({a + shift, b + shift});
  return all;
}

/// Carries positions to the next finer level. Midpoints on the coarse edges give the same surface,
/// so no new intersections; then they move towards the smooth surface through the coarse normals
/// (PN triangles, Vlachos et al. 2001) as far as they meet nothing.
void refine(ClothState& state) {
  const auto parents = parents_of_next(state);
  const auto normal = geometry::vertex_normals(state.x, state.triangles());
  std::vector<Vec3> bulge(parents.size());
  for (std::size_t i = 0; i < parents.size(); ++i) {
    const auto [a, b] = parents[i];
    const Vec3 edge = state.x[b] - state.x[a];
    bulge[i] = (normal[b] * normal[b].dot(edge) - normal[a] * normal[a].dot(edge)) / 8;
  }
  state.x = on_coarse_surface(parents, state.x);
  ++state.level;
  state.make_model();
  state.model->system().begin_step(state.x, std::numeric_limits<double>::infinity());
  state.move_without_collision(bulge);
}

void refine_as_worn(ClothState& state) {
  const auto parents = parents_of_next(state);
  const std::vector<Vec3> before = on_coarse_surface(parents, state.worn->levels[state.level].x);
  const WornCloth::Level& worn = state.worn->levels[++state.level];
  state.x = on_coarse_surface(parents, state.x);
  state.make_model();
  // Fine folds come back, turned with the cloth round them.
  state.move_without_collision(without_impacts(
      state.model->self().candidates().features(), state.x,
      turned_detail(state.triangles(), before, worn.x, state.x), state.tuning.carry.impact_rounds));
  // So does friction, carried by the whole motion of the skin since then.
  state.model->recall(worn.memory);
  state.model->set_body(*state.body);
  state.carry_anchors(
      displacements(skin_motion(state.worn->body->body, state.body->body, worn.x), worn.x));
}

}  // namespace

void settle_coarse_levels(ClothState& state) {
  const LevelTuning& tuning = state.tuning.levels;
  while (!state.is_finest()) {
    state.loosen_friction();
    state.model->set_hardening(0);
    if (!state.must_stop())
      state.settle({.tolerance = tuning.tolerance,
                    .max_iterations = tuning.iterations,
                    .first_dt = tuning.first_dt});
    state.stick();
    state.handed_on[state.start].push_back({state.x, state.model->memory()});
    refine(state);
  }
}

double settle_coarse_levels_as_worn(ClothState& state) {
  const FollowTuning& tuning = state.tuning.follow;
  double deepest = 0;
  while (!state.is_finest()) {
    state.model->set_hardening(0);
    state.settle({.tolerance = state.tuning.levels.tolerance,
                  .max_iterations = tuning.longer * tuning.plan.iterations,
                  .first_dt = state.tuning.levels.first_dt});
    deepest = std::max(deepest, depth_in_skin(state.x, state.body->body));
    refine_as_worn(state);
  }
  return deepest;
}

}  // namespace loosefit::drape

#include "loosefit/drape/phases/wear_in.h"

#include <algorithm>

#include "loosefit/drape/openings.h"
#include "loosefit/drape/phases/follow_posture.h"

namespace loosefit::drape {
namespace {

/// Up along the trunk; a body without joints stands upright.
Vec3 up_the_trunk(const body::Body& body) {
  const auto pelvis = body.joints.find("pelvis"), neck = body.joints.find("neck");
  if (pelvis == body.joints.end() || neck == body.joints.end()) return Vec3::UnitZ();
  return (neck->second - pelvis->second).normalized();
}

/// The hems of what hangs on the shoulders. A cape is left out: no sleeve keeps its neck in place,
/// so the pull would draw the neck over the shoulders.
std::vector<int> hem_vertices(const garment::Garment& garment, const pattern::Pattern& pattern,
                              const body::PosedBody& body) {
  const std::vector<Opening> openings = garment_openings(garment, pattern, body);
  std::vector<int> vertices;
  for (const Opening& hem : openings) {
    if (hem.use != kinds::OpeningUse::hem) continue;
    const bool hangs = std::any_of(openings.begin(), openings.end(), [&](const Opening& other) {
      return other.use == kinds::OpeningUse::neck && other.piece == hem.piece;
    });
    if (hangs) vertices.insert(vertices.end(), hem.loop.begin(), hem.loop.end());
  }
  return vertices;
}

void settle_pulled(ClothState& state) {
  const WearInTuning& tuning = state.tuning.wear_in;
  if (!state.must_stop())
    state.settle({.tolerance = tuning.pull_tolerance,
                  .max_iterations = tuning.pull_iterations,
                  .first_dt = tuning.first_dt,
                  .preparing = true});
}

void let_go(ClothState& state) {
  state.model->set_load({});
  settle_pulled(state);
}

void pull_and_let_go(ClothState& state, double weights) {
  state.model->set_load(hem_pull(state, weights));
  settle_pulled(state);
  let_go(state);
}

void go_there_and_back(ClothState& state, const Movement& movement) {
  const std::shared_ptr<const ContactBody> here = state.body;
  const body::BodyPath back = [&way = movement.way](double share) { return way(1 - share); };
  follow_path(state, movement.way, {.stays = false});
  if (movement.hem_pull > 0) state.model->set_load(hem_pull(state, movement.hem_pull));
  follow_path(state, back, {.stays = true, .known = here});
  if (movement.hem_pull > 0) let_go(state);
}

}  // namespace

particles::VectorField hem_pull(const ClothState& state, double weights) {
  const Vec3 down = -up_the_trunk(state.body->body);
  particles::VectorField force(state.x.size(), Vec3::Zero());
  for (int l = 0; l < state.layer_count(); ++l) {
    const garment::Garment& garment = state.garment(l);
    const std::vector<int> hem =
        hem_vertices(garment, state.layers[l].garment->pattern, state.body->body);
    const double weight = garment.mass * state.options.gravity;
    for (const int v : hem)
      force[state.model->mesh().first_vertex[l] + v] +=
          weights * weight / static_cast<double>(hem.size()) * down;
  }
  return force;
}

void wear_in(ClothState& state) {
  for (const Movement& movement : state.movements) {
    if (state.must_stop()) return;
    state.friction_share = std::min(state.friction_share, movement.friction_share);
    if (movement.way)
      go_there_and_back(state, movement);
    else if (movement.hem_pull > 0)
      pull_and_let_go(state, movement.hem_pull);
  }
}

}  // namespace loosefit::drape

#include "loosefit/drape/settle_garment.h"

#include <algorithm>

#include "loosefit/base/error.h"
#include "loosefit/drape/cleft_cover.h"
#include "loosefit/drape/phases/certify_state.h"
#include "loosefit/drape/phases/contract.h"
#include "loosefit/drape/phases/disturb_start.h"
#include "loosefit/drape/phases/dress_on.h"
#include "loosefit/drape/phases/follow_posture.h"
#include "loosefit/drape/phases/free_penetrations.h"
#include "loosefit/drape/phases/settle_levels.h"
#include "loosefit/drape/phases/wear_in.h"

// How a drape is made, in the order in which it happens. What is tried when a phase fails stands in
// drape/recoveries.cpp, all numbers in drape/settling_tuning.h.
namespace loosefit::drape {
namespace {

/// From the first start round the body to rest on the finest level.
void bring_to_rest(ClothState& state) {
  state.part = "dress";
  state.progress.stage("dress");
  dress_on(state);
  contract_soft(state);
  disturb_start(state);
  contract(state);

  state.part = "posture";
  state.progress.stage("settle");
  follow_posture(state);
  state.part = "wear-in";
  wear_in(state);
  state.soften_contact(false);

  state.part = "settle";
  settle_coarse_levels(state);
  free_penetrations(state);
}

/// What postures start from.
std::shared_ptr<const WornCloth> worn_cloth(ClothState& state) {
  std::vector<WornCloth::Level>& levels = state.handed_on[state.start];
  levels.push_back({state.x, state.model->memory()});
  int iterations = 0;
  for (const PartWork& part : state.report.parts)
    if (part.start == state.start && part.level == state.level && part.part == "settle")
      iterations += part.work.iterations;
  return std::make_shared<const WornCloth>(WornCloth{std::move(levels), state.body, iterations});
}

/// Takes up the cloth as it is worn, on the level on which the posture is followed: the coarsest,
/// where an iteration costs a fraction; the finest for several layers, or when nothing moves.
void take_up(ClothState& state, std::shared_ptr<const WornCloth> worn) {
  state.worn = std::move(worn);
  state.body = state.worn->body;
  const FollowTuning& tuning = state.tuning.follow;
  const bool still = largest_turn(state.body->body, state.path(1.0), tuning) < tuning.no_turn;
  state.level = state.is_single() && !still ? 0 : state.level_count() - 1;
  const WornCloth::Level& level = state.worn->levels[state.level];
  state.x = level.x;
  state.make_model();
  state.model->recall(level.memory);
  state.model->set_body(*state.body);  // the level may remember an older one
}

/// Whether the cloth is caught between folds of skin, which do not let go of it: no use in trying
/// on. `deepest`: how deep coarse levels lay in the skin [m].
bool is_caught(ClothState& state, double deepest) {
  const FollowTuning& tuning = state.tuning.follow;
  if (deepest < tuning.caught_depth) {
    // What was carried lies deep in the layer here and there: all of it would throw the cloth off.
    if (!state.is_as_worn())
      state.model->set_hardening(state.tuning.penetrations.look_hardening.front());
    state.settle({.tolerance = tuning.caught_tolerance,
                  .max_iterations = tuning.longer * tuning.plan.iterations,
                  .first_dt = tuning.finest_first_dt,
                  .preparing = true});
    deepest = depth_in_skin(state.x, state.body->body);
  }
  if (!(deepest > tuning.caught_depth)) return false;
  state.given_up = Stop{.reason = StopReason::caught_in_skin, .depth = deepest};
  return true;
}

/// At rest on the finest level, within so many times the iterations that putting on took there.
void settle_followed(ClothState& state) {
  const FollowTuning& tuning = state.tuning.follow;
  const int most =
      std::max(tuning.least_iterations, tuning.iterations_factor * state.worn->iterations);
  state.budget.limit_phase(most);
  free_penetrations(state);
  const bool at_rest = state.last.reason == solver::SettleOutcome::Reason::converged;
  if (state.budget.phase_is_over() && !at_rest)
    state.given_up = Stop{.reason = StopReason::posture_too_long, .iterations = most};
}

}  // namespace

Drape dress_and_settle(ClothState& state, const body::BodyPath& path,
                       const body::BodyPath& wide_path, std::shared_ptr<const WornCloth>& worn) {
  state.path = path, state.wide_path = wide_path;
  state.arms_go_up = raises_an_arm(path(1.0));
  bring_to_rest(state);
  certify_state(state);
  Drape drape = make_drape(state);
  worn = worn_cloth(state);
  return drape;
}

void put_on_again(ClothState& state) {
  state.keep(state.first_try, state.last.residual);
  state.first_try->stop = state.how_it_ended();
  const solver::SettleOutcome last = state.last;
  state.handed_on.emplace_back();
  state.start = static_cast<int>(state.handed_on.size()) - 1;
  state.level = 0;
  state.friction_share = 1;
  bool is_there = false;
  try {
    bring_to_rest(state);
    is_there = state.last.reason == solver::SettleOutcome::Reason::converged ||
               state.last.residual <= state.options.residual_tolerance;
  } catch (const GeometryError&) {  // the drape that there is counts for more
  }
  if (!is_there) {  // what has not come to rest is no rival, however little it cuts
    state.falling.reset();
    state.last = last;
    state.level = state.level_count() - 1;
    state.body = state.first_try->body;
    state.make_model();
    go_back(state, *state.first_try);
    state.lowest.reset(), state.clear.reset(), state.saddle.reset();
  }
  certify_state(state);
}

Drape follow_wearer(ClothState& state, const body::BodyPath& path,
                    std::shared_ptr<const WornCloth> worn) {
  state.path = path;
  state.part = "posture";
  take_up(state, std::move(worn));
  // On the finest level a soft layer would undo what holds triangles off the skin.
  const bool soft = state.is_single() && !state.is_finest();
  if (soft) state.soften_contact(true);
  follow_posture(state);
  if (soft) state.soften_contact(false);
  const double deepest = settle_coarse_levels_as_worn(state);

  state.part = "settle";
  if (!is_caught(state, deepest)) settle_followed(state);
  certify_state(state);
  return make_drape(state);
}

}  // namespace loosefit::drape

#include "loosefit/drape/recoveries.h"

#include "loosefit/drape/cloth_state.h"
#include "loosefit/drape/phases/certify_state.h"
#include "loosefit/drape/phases/dress_on.h"
#include "loosefit/drape/phases/follow_posture.h"
#include "loosefit/drape/phases/free_penetrations.h"
#include "loosefit/drape/phases/leave_saddle.h"
#include "loosefit/drape/settle_garment.h"

namespace loosefit::drape {
namespace {

int once(const SettlingTuning&) { return 1; }
int always(const SettlingTuning&) { return kNoLimit; }

// Failures.

bool finds_no_room(ClothState& state) { return !state.no_room.empty() && state.wide_path; }

bool step_is_blocked(ClothState& state) {
  const PostureStep& step = state.step;
  return step.blocked && step.length > state.tuning.follow.halved_from * step.least &&
         !state.must_stop();
}

bool lags_behind(ClothState& state) {
  return state.last.residual > state.tuning.follow.lagging * state.tuning.follow.plan.tolerance;
}

bool has_left_field(ClothState& state) { return !state.body->field->covers(bounds(state.x)); }

bool converged_but_above_tolerance(ClothState& state) {
  return state.last.reason == solver::SettleOutcome::Reason::converged && !state.given_up &&
         !state.must_stop() && !state.best_was_taken &&
         (state.certificate.residual > state.options.residual_tolerance ||
          !state.certificate.is_balanced());
}

bool rests_on_saddle(ClothState& state) {
  const Certificate& c = state.certificate;
  return c.settled() && c.stable == false && !state.best_was_taken && !state.is_over() &&
         state.options.integrator == IntegratorKind::quasi_static;
}

/// Also of a drape that was asked to be less near to rest: a kept state may be nearer.
bool may_be_better(ClothState& state) {
  const Certificate& c = state.certificate;
  return !state.best_was_taken && (!c.settled() || c.residual > solver::kRestTolerance);
}

/// Few cuts, or none and no rest: a fold that closed on itself, a pinch that another way does not
/// lead into. Many tell that there is no room. Iterations must do for all of it.
bool may_settle_from_another_start(ClothState& state) {
  const Certificate& c = state.certificate;
  const int cuts = c.intersections_self + c.intersections_body;
  return !c.settled() && cuts <= state.tuning.certify.few_triangles && !state.worn &&
         !state.must_stop() && state.budget.is_half_left() &&
         state.options.integrator == IntegratorKind::quasi_static;
}

// Actions that are not phases of their own.

void take_wide_path(ClothState& state) {
  state.report.no_room = state.no_room;
  state.path = state.wide_path;
  lay_round_body(state);
}

void halve_step(ClothState& state) { state.step.length /= 2; }

void settle_longer(ClothState& state) {
  const FollowTuning& tuning = state.tuning.follow;
  const StepPlan& plan = tuning.plan;
  state.settle({.tolerance = tuning.lagging * plan.tolerance,
                .max_iterations = tuning.longer * plan.iterations,
                .first_dt = tuning.first_dt,
                .preparing = true});
}

void renew_field(ClothState& state) {
  state.outgrown.push_back(state.body);
  state.body = with_field(state.body->body, bounds(state.x), state.body->field->spacing(),
                          state.tuning.carry, state.arms_go_up);
  state.model->set_body(*state.body);
}

}  // namespace

const Recoveries& recoveries() {
  using Kind = RecoveryKind;
  using Point = RecoveryPoint;
  static const Recoveries kTable = {
      {Kind::wide_posture, Point::dressed, "dressing posture with more room",
       "the garment finds no room between arms and trunk",
       "with the arms farther apart there is most; from there the posture is followed as usual",
       once, finds_no_room, take_wide_path},
      {Kind::shorter_step, Point::before_step, "shorter step of the body",
       "the cloth cannot go along with a step of the body, or would lie deep in the skin",
       "a body that goes where the cloth cannot follow would pass through it; settling after half "
       "the step makes room",
       always, step_is_blocked, halve_step},
      {Kind::settle_longer, Point::after_step, "settle longer after a step",
       "the forces are far from balanced after a step of the body",
       "cloth that is pressed deep into the skin would be pulled through it on the next step",
       always, lags_behind, settle_longer},
      {Kind::renew_field, Point::before_settle, "field of distances round the cloth",
       "cloth has come near the edge of the field of distances to the skin",
       "off its grid the energy of contact jumps, and no step descends any more", always,
       has_left_field, renew_field},
      {Kind::free_cuts, Point::at_rest, "free cutting triangles from the skin",
       "triangles cut the skin between their contact points",
       "a contact point where a corner or an edge of the skin reaches into them keeps it out; what "
       "still cuts is held off",
       [](const SettlingTuning& tuning) { return tuning.penetrations.rounds; }, find_penetrations,
       free_cuts},
      {Kind::nearer_to_rest, Point::certified, "settle nearer to rest",
       "the certificate, which refreshes contacts, finds more residual than settling had",
       "contacts that came or went have to find their balance, too",
       [](const SettlingTuning& tuning) { return tuning.certify.attempts; },
       converged_but_above_tolerance, settle_nearer},
      {Kind::leave_saddle, Point::certified, "leave a saddle of the energy",
       "the forces balance where the energy is no minimum: the least push would send the cloth "
       "elsewhere",
       "along the direction of lowest curvature the energy falls, and beyond it there is a minimum",
       [](const SettlingTuning& tuning) { return tuning.certify.saddle_attempts; }, rests_on_saddle,
       leave_saddle},
      {Kind::best_state, Point::certified, "best state so far", "the drape is not settled",
       "the way may have led away from a better state: without intersections, or of a lower "
       "residual",
       once, may_be_better, take_best_state},
      {Kind::another_start, Point::certified, "putting the garment on once more, shifted a little",
       "the first drape of a garment is not settled, and few triangles cut",
       "folds are not unique: from a start a millimetre beside, others form", once,
       may_settle_from_another_start, put_on_again}};
  return kTable;
}

}  // namespace loosefit::drape
